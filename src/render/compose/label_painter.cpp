#include "render/compose/label_painter.h"

#include <algorithm>
#include <cmath>

namespace twrench::render {
namespace {

constexpr double halo_width = 0.14;  // em
constexpr double halo_opacity = 0.75;
constexpr double label_distance = 0.1;  // em, from what is named

}  // namespace

LabelPainter::LabelPainter(const canvas::Font& font, double size, const scene::Color& halo,
                           const image::Area& pane, const std::vector<image::Area>& taken)
    : font_(font), size_(size), halo_(halo), pane_(pane) {
  for (const auto& [x, y, width, height] : taken) {
    taken_.push_back({static_cast<double>(x), static_cast<double>(y), static_cast<double>(width),
                      static_cast<double>(height)});
  }
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

std::vector<Layer> LabelPainter::paint(const std::vector<Label>& labels) const {
  std::vector<Layer> layers;
  std::vector<Box> taken = taken_;
  for (const Label& label : labels) {
    const canvas::Line line = canvas::typeset(font_, label.text);
    const double air = halo_width * size_ + 1;
    const double width = line.width * size_ + 2 * air;
    const double height = 1.3 * size_ + 2 * air;
    const Eigen::Vector2d half(width / 2, height / 2);
    const double offset = half.dot(label.away.cwiseAbs()) + label_distance * size_;
    const Eigen::Vector2d corner = label.anchor + offset * label.away - half;
    const Box box = placed({corner.x(), corner.y(), width, height}, taken);
    taken.push_back(box);
    const int left = std::max(pane_.x, static_cast<int>(std::floor(box.x)));
    const int top = std::max(pane_.y, static_cast<int>(std::floor(box.y)));
    const int right = std::min(pane_.x + pane_.width, static_cast<int>(std::ceil(box.x + width)));
    const int bottom =
        std::min(pane_.y + pane_.height, static_cast<int>(std::ceil(box.y + height)));
    Layer layer{image::Image(right - left, bottom - top, 4), left, top};
    canvas::Canvas canvas(layer.image, left, top);
    const canvas::Canvas::Point at{box.x + air,
                                   box.y + air + 0.65 * size_ + font_.cap_height() * size_ / 2};
    canvas.text_halo(line, size_, at, halo_width * size_, {halo_, halo_opacity});
    canvas.text(line, size_, at, {label.color});
    layers.push_back(std::move(layer));
  }
  return layers;
}

}  // namespace twrench::render
