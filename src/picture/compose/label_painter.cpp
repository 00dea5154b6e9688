#include "picture/compose/label_painter.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace twrench::picture {
namespace {

using Eigen::Vector2d;

// All in em.
constexpr double halo_width = 0.14;
constexpr double label_distance = 0.1;     // from the named object
constexpr double clearance = 0.45;         // between the middle of a thin arrow and another's name
constexpr double letter_height = 0.75;     // of most letters
constexpr double unled = 0.35, led = 0.7;  // how far a label moves before a line leads to it
constexpr double leader_width = 0.07, leader_gap = 0.1;

double ease(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// Returns how far to move up something that is `s` above a line, so that it is at least `least`
/// away from the line on either side. The result is continuous in `s`. An object that approaches
/// from below crosses the line early and quickly; one that stays near the line is above it.
double kept_off(double s, double least) {
  if (std::abs(s) >= least) return 0;
  return least * (2 * ease(-0.95 * least, -0.8 * least, s) - 1) - s;
}

}  // namespace

LabelPainter::LabelPainter(const canvas::Font& font, double size, const Color& halo,
                           const image::Area& pane, const std::vector<image::Area>& taken)
    : font_(font), size_(size), halo_(halo), pane_(pane) {
  for (const auto& [x, y, width, height] : taken) {
    taken_.push_back({static_cast<double>(x), static_cast<double>(y), static_cast<double>(width),
                      static_cast<double>(height)});
  }
}

/// Moves the box off the lines of other labels' objects, perpendicularly to them and preferably
/// upwards.
LabelPainter::Box LabelPainter::beside_objects(Box box, const std::vector<Label>& labels,
                                               const Label& own) const {
  const double air = halo_width * size_ + 1;
  for (const Label& other : labels) {
    if (&other == &own || !other.root) continue;
    const double clear = std::max(clearance * size_, other.half_width + label_distance * size_);
    const Vector2d half = Vector2d(box.width / 2 - air, letter_height * size_ / 2).array() + clear;
    const Vector2d way = other.anchor - *other.root;
    if (!(way.norm() > size_)) continue;  // seen end-on
    const Vector2d along = way.normalized();
    const Vector2d up =
        along.x() > 0 ? Vector2d(along.y(), -along.x()) : Vector2d(-along.y(), along.x());
    const Vector2d from_root = box.middle() - *other.root;
    const double forward = from_root.dot(along);
    const double past = std::max({forward - way.norm(), -forward, 0.0});
    const double end = half.dot(along.cwiseAbs());
    if (past >= end) continue;
    const double least = half.dot(up.cwiseAbs()) * std::sqrt(1 - past * past / (end * end));
    const Vector2d move = kept_off(from_root.dot(up), least) * up;
    box.x += move.x();
    box.y += move.y();
  }
  return box;
}

/// Moves the box out of each taken one by the shortest way, and back into the pane.
LabelPainter::Box LabelPainter::placed(Box box, const std::vector<Box>& taken) const {
  for (const Box& other : taken) {
    const double right = other.x + other.width - box.x;  // distances to each side
    const double left = box.x + box.width - other.x;
    const double down = other.y + other.height - box.y;
    const double up = box.y + box.height - other.y;
    const double least = std::min({right, left, down, up});
    if (least <= 0) continue;
    if (least == up) {
      box.y -= up;
    } else if (least == down) {
      box.y += down;
    } else {
      box.x += least == left ? -left : right;
    }
  }
  box.x =
      std::clamp(box.x, 1.0 * pane_.x, std::max(1.0 * pane_.x, pane_.x + pane_.width - box.width));
  box.y = std::clamp(box.y, 1.0 * pane_.y,
                     std::max(1.0 * pane_.y, pane_.y + pane_.height - box.height));
  return box;
}

/// Draws a line from the end of the object to the letters.
void LabelPainter::lead_to(const Box& box, const Label& label, double opacity,
                           canvas::Canvas& canvas) const {
  const double air = halo_width * size_ + 1;
  const Vector2d half(box.width / 2 - air, letter_height * size_ / 2);
  const Vector2d middle = box.middle();
  const Vector2d nearest = label.anchor.cwiseMax(middle - half).cwiseMin(middle + half);
  const Vector2d way = nearest - label.anchor;
  const double gap = leader_gap * size_;
  if (way.norm() <= 2 * gap) return;
  const Vector2d first = label.anchor + gap * way.normalized();
  const Vector2d last = nearest - gap * way.normalized();
  const std::array line{canvas::Canvas::Point{first.x(), first.y()},
                        canvas::Canvas::Point{last.x(), last.y()}};
  const double width = std::max(1.0, leader_width * size_);
  canvas.polyline(line, 2.5 * width, {halo_, opacity});
  canvas.polyline(line, width, {label.color, opacity});
}

/// `moved` is the distance in em from where the label would be if nothing were in its way.
Layer LabelPainter::painted(const Label& label, const canvas::Line& line, const Box& box,
                            double moved) const {
  const double opacity = ease(unled, led, moved);
  const Vector2d low(box.x, box.y), high = low + Vector2d(box.width, box.height);
  const Vector2d from = opacity > 0 ? low.cwiseMin(label.anchor) : low;
  const Vector2d to = opacity > 0 ? high.cwiseMax(label.anchor) : high;
  const int left = std::max(pane_.x, static_cast<int>(std::floor(from.x())));
  const int top = std::max(pane_.y, static_cast<int>(std::floor(from.y())));
  const int right = std::min(pane_.x + pane_.width, static_cast<int>(std::ceil(to.x())));
  const int bottom = std::min(pane_.y + pane_.height, static_cast<int>(std::ceil(to.y())));
  Layer layer{image::Image(right - left, bottom - top, 4), left, top};
  canvas::Canvas canvas(layer.image, left, top);
  if (opacity > 0) lead_to(box, label, opacity, canvas);
  const double air = halo_width * size_ + 1;
  const canvas::Canvas::Point at{box.x + air,
                                 box.y + air + 0.65 * size_ + font_.cap_height() * size_ / 2};
  canvas.text_halo(line, size_, at, halo_width * size_, {halo_});
  canvas.text(line, size_, at, {label.color});
  return layer;
}

std::vector<Layer> LabelPainter::paint(const std::vector<Label>& labels) const {
  std::vector<Layer> layers;
  std::vector<Box> taken = taken_;
  for (const Label& label : labels) {
    const canvas::Line line = canvas::typeset(font_, label.text);
    const double air = halo_width * size_ + 1;
    const double width = line.width * size_ + 2 * air;
    const double height = 1.3 * size_ + 2 * air;
    const Vector2d half(width / 2, height / 2);
    const double offset = half.dot(label.away.cwiseAbs()) + label_distance * size_;
    const Vector2d corner = label.anchor + offset * label.away - half;
    const Box free{corner.x(), corner.y(), width, height};
    const Box beside = beside_objects(free, labels, label);
    Box box = placed(beside, taken);
    if (box.middle() != beside.middle()) {  // perhaps over an arrow
      box = placed(beside_objects(box, labels, label), taken);
    }
    taken.push_back(box);
    layers.push_back(painted(label, line, box, (box.middle() - free.middle()).norm() / size_));
  }
  return layers;
}

}  // namespace twrench::picture
