#include "picture/hud/plot_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "picture/hud/hud.h"
#include "picture/hud/panel.h"

namespace twrench::picture {
namespace {

constexpr double range = 1.12;  // of the values that a plot holds: those of SO(3), with a margin
constexpr double faint = 0.32;  // opacity of the future
constexpr double line_opacity = 0.22;  // of zero lines and flips

}  // namespace

double PlotPanel::Plot::y(double value) const {
  const double held = std::clamp(value, -range, range);  // a method may leave SO(3)
  return area.y + area.height * (0.5 - 0.5 * held / range);
}

PlotPanel::PlotPanel(const scene::Scene& scene, const std::vector<timeline::Solution>& solutions,
                     const image::Area& area, double thickness, const OverlayColors& colors)
    : colors_(colors),
      duration_(scene.motion.duration),
      solutions_(solutions.size()),
      thickness_(thickness),
      future_(layer_around(area, 0, {0, 0, scene.film.width, scene.film.height})) {
  canvas::Canvas canvas = ground();
  draw_panel(canvas, area, 8 * thickness, colors);
}

void PlotPanel::mark_zeros() {
  canvas::Canvas canvas = ground();
  for (const Plot& plot : plots_) {
    canvas.rectangle(plot.area.x, std::round(plot.y(0)), plot.area.width, 1,
                     {colors_.dim, line_opacity});
  }
}

void PlotPanel::mark_flips(const timeline::Solution& solution) {
  canvas::Canvas canvas = ground();
  for (const double flip : solution.flip_times) {
    for (const Plot& plot : plots_) {
      canvas.rectangle(std::round(plot.x(flip / duration_)), plot.area.y, 1, plot.area.height,
                       {colors_.dim, line_opacity});
    }
  }
}

void PlotPanel::add_curves(const std::vector<timeline::Solution>& solutions) {
  past_ = future_;
  canvas::Canvas future = ground();
  canvas::Canvas past(past_.image, past_.x, past_.y);
  for (std::size_t i = 0; i < solutions.size(); ++i) {
    draw_curves(future, solutions[i], i, faint);
    draw_curves(past, solutions[i], i, 1);
  }
}

void PlotPanel::draw_curves(canvas::Canvas& canvas, const timeline::Solution& solution,
                            std::size_t index, double opacity) const {
  for (const Plot& plot : plots_) {
    std::vector<canvas::Canvas::Point> points;
    for (const motion::Sample& sample : solution.whole) {
      points.push_back({plot.x(sample.t / duration_), plot.y(plot.value(sample))});
    }
    canvas.polyline(points, thickness_, {ink(plot, index), opacity});
  }
}

PlotPanel::Plot PlotPanel::component(int row, int column, const image::Area& area) {
  return {Eigen::Vector3d::Unit(row), Eigen::Vector3d::Unit(column),
          static_cast<std::size_t>(3 * row + column), area};
}

std::string PlotPanel::name_of(const Plot& component) {
  static constexpr std::array digits{"₁", "₂", "₃"};
  return fmt::format("x{}{}", digits[component.color / 3], digits[component.color % 3]);
}

Color PlotPanel::ink(const Plot& plot, std::size_t solution) const {
  if (compares()) return solution_color(colors_, solution);
  return colors_.curve[plot.color];
}

std::vector<Layer> PlotPanel::draw(const timeline::FrameState& state) {
  Layer layer = future_;
  const double share = std::clamp(state.solutions[0].sample.t / duration_, 0.0, 1.0);
  for (const Plot& plot : plots_) {
    const int margin = static_cast<int>(std::ceil(thickness_));  // of a curve beyond its plot
    const int left = plot.area.x - margin;
    copy_area(past_, layer,
              {left, plot.area.y - margin, static_cast<int>(std::lround(plot.x(share))) - left,
               plot.area.height + 2 * margin});
  }
  canvas::Canvas canvas(layer.image, layer.x, layer.y);
  const double width = std::max(1.0, 0.6 * thickness_);
  for (const Plot& plot : plots_) {
    canvas.rectangle(plot.x(share) - width / 2, plot.area.y, width, plot.area.height,
                     {colors_.text, 0.6});
    for (std::size_t i = 0; i < solutions_; ++i) {
      const double value = plot.value(state.solutions[i].sample);
      canvas.disc({plot.x(share), plot.y(value)}, 1.8 * thickness_, {ink(plot, i)});
    }
  }
  std::vector<Layer> layers;
  layers.push_back(std::move(layer));
  return layers;
}

}  // namespace twrench::picture
