#include "picture/hud/curve_panel.h"

#include <fmt/format.h>
#include <twrench/motion/stability.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/time_unit.h"
#include "picture/hud/captions.h"
#include "picture/hud/hud_text.h"
#include "scene/prediction.h"

namespace twrench::picture {
namespace {

// em
constexpr double panel_padding = 0.8, caption_line = 1.5, scale_width = 1.9, times_line = 1.5;
constexpr double least_width = 16, least_caption_height = 5, least_times_height = 7;
constexpr double flip_label_gap = 0.6;

/// The principal axis that turns over or, if none does, the one nearest to L.
body::PrincipalAxes::Axis shown_axis(const timeline::Solution& solution) {
  if (solution.flips) return body::PrincipalAxes::intermediate;
  return motion::Tilt(solution.body).axis();
}

}  // namespace

CurvePanel::CurvePanel(const scene::Scene& scene, const std::vector<timeline::Solution>& solutions,
                       const Layout& layout, const canvas::Typeface& typeface,
                       const OverlayColors& colors)
    : PlotPanel(scene, solutions, *layout.curve, std::max(1.0, 0.14 * layout.text.caption), colors),
      font_(typeface.regular),
      size_(layout.text.caption) {
  const image::Area& area = *layout.curve;
  const bool flips = !compares() && !solutions[0].flip_times.empty();
  captioned_ =
      area.width >= 0.75 * least_width * size_ && area.height >= least_caption_height * size_;
  scaled_ = area.width >= least_width * size_ && captioned_;
  timed_ = flips && scaled_ && area.height >= least_times_height * size_;
  const auto turning = std::ranges::find_if(solutions, &timeline::Solution::turns_over);
  place_plot(area, turning == solutions.end() ? solutions[0] : *turning);
  if (plots_.empty()) return;
  if (captioned_) draw_caption(scene, area);
  if (scaled_) draw_scale(scene);
  mark_zeros();
  if (!compares()) mark_flips(solutions[0]);
  if (timed_) label_flips(solutions[0].flip_times);
  add_curves(solutions);
}

void CurvePanel::place_plot(const image::Area& area, const timeline::Solution& solution) {
  const double padding = std::min(panel_padding * size_, 0.08 * area.height);
  const int left =
      static_cast<int>(std::ceil(area.x + padding + (scaled_ ? scale_width * size_ : 0)));
  const int top =
      static_cast<int>(std::ceil(area.y + padding + (captioned_ ? caption_line * size_ : 0)));
  const int right = static_cast<int>(area.x + area.width - padding);
  const int bottom =
      static_cast<int>(area.y + area.height - padding - (timed_ ? times_line * size_ : 0));
  if (!(right > left && bottom > top)) return;
  const Eigen::Matrix3d& axes = solution.body.principal().axes;
  const body::PrincipalAxes::Axis shown = shown_axis(solution);
  Eigen::Index nearest = 0;
  axes.col(shown).cwiseAbs().maxCoeff(&nearest);
  const int k = static_cast<int>(nearest);
  axis_ = scene::axis_name(axes, shown);
  Plot plot = component(k, k, {left, top, right - left, bottom - top});
  plot.axis = scene::named_axis(axes, shown);
  plot.direction = solution.whole.front().X * plot.axis;
  plots_.push_back(plot);
}

void CurvePanel::draw_caption(const scene::Scene& scene, const image::Area& area) {
  const double padding = panel_padding * size_;
  const double room = (area.width - 2 * padding) / size_;
  const bool is_component = plots_[0].direction == plots_[0].axis && !axis_.starts_with('I');
  const std::string meaning = captions::curve(scene.body, axis_, is_component, scene.language);
  canvas::Line line = canvas::typeset(
      font_, is_component ? fmt::format("{} ({})", meaning, name_of(plots_[0])) : meaning);
  if (line.width > room) line = canvas::typeset_within(font_, meaning, room);
  ground().text(line, size_, {area.x + padding, area.y + padding + 0.85 * size_}, {colors_.text});
}

/// Labels the two ends of the scale: directions along space x as arrows if the camera sees them
/// from a fixed side, others as numbers.
void CurvePanel::draw_scale(const scene::Scene& scene) {
  const Plot& plot = plots_[0];
  const double side = std::cos(scene.camera.azimuth);
  for (const double end : {1.0, -1.0}) {
    if (plot.direction == Eigen::Vector3d::UnitX() && scene.camera.orbit == 0 &&
        std::abs(side) > 0.5) {
      draw_arrow(plot.y(end), side > 0 ? end : -end);
    } else {
      ground().text(canvas::typeset(font_, end > 0 ? "1" : "−1"), size_,
                    {plot.area.x - 0.6 * size_, plot.y(end) + 0.35 * size_}, {colors_.dim},
                    canvas::Canvas::Align::right);
    }
  }
}

void CurvePanel::draw_arrow(double y, double direction) {
  const double middle = plots_[0].area.x - 0.5 * scale_width * size_ - 0.2 * size_;
  const double half = 0.55 * size_, head = 0.32 * size_;
  const double tip = middle + direction * half;
  const canvas::Canvas::Ink ink{colors_.dim};
  const double width = std::max(1.0, 0.1 * size_);
  using Point = canvas::Canvas::Point;
  ground().polyline(std::array{Point{middle - direction * half, y}, Point{tip, y}}, width, ink);
  ground().polyline(std::array{Point{tip - direction * head, y - head}, Point{tip, y},
                               Point{tip - direction * head, y + head}},
                    width, ink);
}

/// Draws a tick and the time at each flip. If the times would overlap, only every second, third or
/// n-th flip has its time.
void CurvePanel::label_flips(const std::vector<double>& times) {
  const Plot& plot = plots_[0];
  const double bottom = plot.area.y + plot.area.height;
  const double tick = std::max(1.0, 0.1 * size_);
  const TimeUnit unit = time_unit(duration_);
  const auto text = [&](double time) {
    return canvas::typeset(font_, hud_text::rounded_time(time, unit));
  };
  const double widest = (text(times.back()).width + flip_label_gap) * size_;
  const double covered = plot.x(times.back() / duration_) - plot.x(times.front() / duration_);
  const double labels = std::max(1.0, covered / widest + 1);
  const auto stride =
      static_cast<std::size_t>(std::ceil(static_cast<double>(times.size()) / labels));
  canvas::Canvas canvas = ground();
  double free = plot.area.x;  // everything to the left is taken
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double x = std::round(plot.x(times[i] / duration_));
    canvas.rectangle(x - tick / 2, bottom - 0.5 * size_, tick, 0.5 * size_, {colors_.text, 0.8});
    if (i % stride != 0) continue;
    const canvas::Line line = text(times[i]);
    const double half = line.width * size_ / 2;
    const double last = std::max(plot.area.x + plot.area.width - half, plot.area.x + half);
    const double centre = std::clamp(x, plot.area.x + half, last);
    if (centre - half < free) continue;  // at an end of the plot
    canvas.text(line, size_, {centre, bottom + 1.15 * size_}, {colors_.dim},
                canvas::Canvas::Align::centre);
    free = centre + half + flip_label_gap * size_ / 2;
  }
}

}  // namespace twrench::picture
