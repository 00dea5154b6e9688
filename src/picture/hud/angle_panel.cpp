#include "picture/hud/angle_panel.h"

#include <twrench/math/so3.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "picture/hud/hud.h"
#include "picture/hud/panel.h"
#include "scene/phrase.h"

namespace twrench::picture {
namespace {

using Point = canvas::Canvas::Point;

constexpr double faint_angles = 0.32;  // opacity of the future

double angle_between(const motion::Sample& from, const motion::Sample& to) {
  return so3::log(from.X.transpose() * to.X).norm();
}

/// Against which of the motions the others are measured: a recorded one, else the exact one, else
/// the first.
std::size_t reference_of(const std::vector<timeline::Solution>& solutions) {
  const auto recorded = [](const timeline::Solution& one) { return one.recording != nullptr; };
  const auto exact = [](const timeline::Solution& one) { return one.method->exact(); };
  auto found = std::ranges::find_if(solutions, recorded);
  if (found == solutions.end()) found = std::ranges::find_if(solutions, exact);
  return found == solutions.end() ? 0 : static_cast<std::size_t>(found - solutions.begin());
}

/// The scale holds the greatest angle of each motion and at least three decades below it.
AngleScale scale_of(const std::vector<timeline::Solution>& solutions, std::size_t reference,
                    const image::Area& plot, double size) {
  double largest = 10 * angle_round_off, smallest = std::numbers::pi;
  for (std::size_t i = 0; i < solutions.size(); ++i) {
    if (i == reference) continue;
    double greatest = 10 * angle_round_off;
    for (std::size_t k = 0; k < solutions[i].whole.size(); ++k) {
      greatest =
          std::max(greatest, angle_between(solutions[reference].whole[k], solutions[i].whole[k]));
    }
    largest = std::max(largest, greatest);
    smallest = std::min(smallest, greatest);
  }
  const double top = 10 * decade_below(largest);
  return {std::max(1e-3 * decade_below(smallest), angle_round_off),
          top > std::numbers::pi / 2 ? std::numbers::pi : top, plot, size};
}

}  // namespace

AnglePanel::AnglePanel(const scene::Scene& scene, const std::vector<timeline::Solution>& solutions,
                       const Layout& layout, const canvas::Typeface& typeface,
                       const OverlayColors& colors)
    : colors_(colors),
      duration_(scene.motion.duration),
      thickness_(std::max(1.0, 0.14 * layout.text.caption)),
      reference_(reference_of(solutions)),
      future_(layer_around(*layout.angle, 0, {0, 0, scene.film.width, scene.film.height})) {
  const double size = layout.text.caption;
  const image::Area area = panel_content(*layout.angle, size);
  const int left = area.x + static_cast<int>(AngleScale::number_width * size);
  const int top = area.y + static_cast<int>(1.4 * AngleScale::line_height * size);
  scale_ = scale_of(solutions, reference_,
                    {left, top, area.x + area.width - left, area.y + area.height - top}, size);
  const timeline::Solution& reference = solutions[reference_];
  for (const timeline::Solution& solution : solutions) {
    std::vector<Point>& curve = curves_.emplace_back();
    for (std::size_t k = 0; &solution != &reference && k < solution.whole.size(); ++k) {
      const double angle = angle_between(reference.whole[k], solution.whole[k]);
      curve.push_back(place(solution.whole[k].t, angle));
    }
  }
  canvas::Canvas future(future_.image, future_.x, future_.y);
  draw_panel(future, *layout.angle, 8 * thickness_, colors);
  const std::string name =
      scene::Phrase("angle from {}", "vinkel fra {}").in(scene.language, reference.name);
  future.text(canvas::typeset_within(typeface.regular, name, area.width / size), size,
              {static_cast<double>(area.x), area.y + 0.85 * size}, {colors.text});
  scale_.draw(future, typeface.regular, colors);
  past_ = future_;
  canvas::Canvas past(past_.image, past_.x, past_.y);
  draw_curves(future, faint_angles);
  draw_curves(past, 1);
}

Point AnglePanel::place(double time, double angle) const {
  return {scale_.plot.x + time / duration_ * scale_.plot.width, scale_.y(angle)};
}

void AnglePanel::draw_curves(canvas::Canvas& canvas, double opacity) const {
  for (std::size_t i = 0; i < curves_.size(); ++i) {
    canvas.polyline(curves_[i], thickness_, {solution_color(colors_, i), opacity});
  }
}

std::vector<Layer> AnglePanel::draw(const timeline::FrameState& state) {
  Layer layer = future_;
  const motion::Sample& reference = state.solutions[reference_].sample;
  const double time = std::clamp(reference.t, 0.0, duration_);
  const double now = place(time, 0).x;
  const image::Area& plot = scale_.plot;
  const int margin = static_cast<int>(std::ceil(thickness_));  // of the curves beyond the plot
  const int left = plot.x - margin;
  copy_area(
      past_, layer,
      {left, plot.y - margin, static_cast<int>(std::lround(now)) - left, plot.height + 2 * margin});
  canvas::Canvas canvas(layer.image, layer.x, layer.y);
  const double width = std::max(1.0, 0.6 * thickness_);
  canvas.rectangle(now - width / 2, plot.y, width, plot.height, {colors_.text, 0.6});
  for (std::size_t i = 0; i < state.solutions.size(); ++i) {
    if (i == reference_) continue;
    const double angle = angle_between(reference, state.solutions[i].sample);
    canvas.disc(place(time, angle), 1.8 * thickness_, {solution_color(colors_, i)});
  }
  std::vector<Layer> layers;
  layers.push_back(std::move(layer));
  return layers;
}

}  // namespace twrench::picture
