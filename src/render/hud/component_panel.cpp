#include "render/hud/component_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render/hud/hud.h"

namespace twrench::render {
namespace {

constexpr double range = 1.12;  // of the values that a plot holds: those of SO(3), with a margin
constexpr double faint = 0.32;  // opacity of the future
constexpr double line_opacity = 0.22;  // of zero lines and flips

/// Copies the contents of `area` between two layers at the same position.
void copy(const Layer& from, Layer& to, const image::Area& area) {
  const image::Area held = image::common(area, from.area());
  for (int y = held.y; y < held.y + held.height; ++y) {
    const auto offset = static_cast<std::ptrdiff_t>(from.image.row_bytes()) * (y - from.y) +
                        4 * static_cast<std::ptrdiff_t>(held.x - from.x);
    std::copy_n(from.image.pixels.begin() + offset, 4 * held.width,
                to.image.pixels.begin() + offset);
  }
}

}  // namespace

double ComponentPanel::Plot::y(double value) const {
  const double held = std::clamp(value, -range, range);  // a method may leave SO(3)
  return area.y + area.height * (0.5 - 0.5 * held / range);
}

ComponentPanel::ComponentPanel(const scene::Scene& scene,
                               const std::vector<timeline::Solution>& solutions,
                               const Layout& layout, const canvas::Typeface& typeface,
                               const OverlayColors& colors)
    : colors_(colors),
      duration_(scene.motion.duration),
      solutions_(solutions.size()),
      thickness_(std::max(1.0, 0.09 * layout.text.caption)) {
  const image::Area& area = *layout.components;
  place_plots(area, layout.text.caption);
  const int feather = static_cast<int>(2.2 * layout.text.caption);
  future_ = layer_around(area, feather, {0, 0, scene.film.width, scene.film.height});
  canvas::Canvas future(future_.image, future_.x, future_.y);
  future.soft_panel(area, feather, {colors.panel, colors.panel_opacity});
  draw_frames(future, layout, typeface);
  // The flips of several methods that disagree would clutter the plots.
  for (const double flip : solutions_ == 1 ? solutions[0].flip_times : std::vector<double>{}) {
    for (const Plot& plot : plots_) {
      future.rectangle(std::round(plot.x(flip / duration_)), plot.area.y, 1, plot.area.height,
                       {colors_.dim, line_opacity});
    }
  }
  past_ = future_;
  canvas::Canvas past(past_.image, past_.x, past_.y);
  for (std::size_t i = 0; i < solutions.size(); ++i) {
    draw_curves(future, solutions[i], i, faint);
    draw_curves(past, solutions[i], i, 1);
  }
}

void ComponentPanel::place_plots(const image::Area& area, double label_size) {
  const int columns = is_strip(area) ? 9 : 3;
  const int rows = 9 / columns;
  const int gap = std::max(2, static_cast<int>(0.7 * label_size));
  const int label = static_cast<int>(std::ceil(1.25 * label_size));
  for (int i = 0; i < 9; ++i) {
    const int column = i % columns;
    const int row = i / columns;
    const int left = area.x + column * (area.width + gap) / columns;
    const int right = area.x + (column + 1) * (area.width + gap) / columns - gap;
    const int top = area.y + row * (area.height + gap) / rows + label;
    const int bottom = area.y + (row + 1) * (area.height + gap) / rows - gap;
    if (right <= left || bottom <= top) continue;
    plots_.push_back({i / 3, i % 3, {left, top, right - left, bottom - top}});
  }
}

void ComponentPanel::draw_frames(canvas::Canvas& canvas, const Layout& layout,
                                 const canvas::Typeface& typeface) const {
  static constexpr std::array digits{"₁", "₂", "₃"};
  const double size = layout.text.caption;
  for (const Plot& plot : plots_) {
    const std::string label = fmt::format("x{}{}", digits[static_cast<std::size_t>(plot.row)],
                                          digits[static_cast<std::size_t>(plot.column)]);
    const scene::Color color = solutions_ == 1 ? ink(plot, 0) : colors_.dim;
    canvas.text(canvas::typeset(typeface.regular, label), size,
                {static_cast<double>(plot.area.x), plot.area.y - 0.35 * size}, {color});
    const double zero = std::round(plot.y(0));
    canvas.rectangle(plot.area.x, zero, plot.area.width, 1, {colors_.dim, line_opacity});
  }
}

void ComponentPanel::draw_curves(canvas::Canvas& canvas, const timeline::Solution& solution,
                                 std::size_t index, double opacity) const {
  for (const Plot& plot : plots_) {
    std::vector<canvas::Canvas::Point> points;
    for (const motion::Sample& sample : solution.whole) {
      points.push_back({plot.x(sample.t / duration_), plot.y(sample.X(plot.row, plot.column))});
    }
    canvas.polyline(points, thickness_, {ink(plot, index), opacity});
  }
}

scene::Color ComponentPanel::ink(const Plot& plot, std::size_t solution) const {
  if (solutions_ > 1) return solution_color(colors_, solution);
  return colors_
      .curve[3 * static_cast<std::size_t>(plot.row) + static_cast<std::size_t>(plot.column)];
}

std::vector<PendingLayer> ComponentPanel::draw(const timeline::FrameState& state) {
  Layer layer = future_;
  const double share = std::clamp(state.solutions[0].sample.t / duration_, 0.0, 1.0);
  for (const Plot& plot : plots_) {
    const int margin = static_cast<int>(std::ceil(thickness_));  // of a curve beyond its plot
    const int left = plot.area.x - margin;
    copy(past_, layer,
         {left, plot.area.y - margin, static_cast<int>(std::lround(plot.x(share))) - left,
          plot.area.height + 2 * margin});
  }
  canvas::Canvas canvas(layer.image, layer.x, layer.y);
  const double width = std::max(1.0, 0.6 * thickness_);
  for (const Plot& plot : plots_) {
    canvas.rectangle(plot.x(share) - width / 2, plot.area.y, width, plot.area.height,
                     {colors_.text, 0.6});
    for (std::size_t i = 0; i < solutions_; ++i) {
      const double value = state.solutions[i].sample.X(plot.row, plot.column);
      canvas.disc({plot.x(share), plot.y(value)}, 1.8 * thickness_, {ink(plot, i)});
    }
  }
  std::vector<PendingLayer> layers;
  layers.push_back(ready(std::move(layer)));
  return layers;
}

}  // namespace twrench::render
