#include "picture/hud/tilt_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <span>

#include "picture/hud/hud_text.h"
#include "picture/hud/panel.h"
#include "scene/phrase.h"
#include "scene/prediction.h"

namespace twrench::picture {
namespace {

using Point = canvas::Canvas::Point;

constexpr double greatest_tilt = std::numbers::pi;
constexpr double faint_future = 0.5;
constexpr double dash_em = 0.55;      // length of a dash, and of the gap between two
constexpr double value_em = 1.3;      // size of the current value
constexpr double least_value = 20;    // its least size in px, in a picture of 1080
constexpr double tick_em = 0.7;       // height of a mark's tick
constexpr double least_gap_em = 0.5;  // between two marks

/// Returns the bottom of the scale in rad: a power of ten in degrees, below the least tilt of the
/// film.
double bottom_of(const motion::Tilt& tilt, const std::vector<motion::Sample>& whole) {
  double least = degree;
  for (const motion::Sample& sample : whole) {
    const double value = tilt.of(sample);
    if (value > angle_round_off) least = std::min(least, value);
  }
  return decade_below(least);
}

/// The linearised motion predicts the tilt of a rigid body. Of others, only the axis is named.
std::string prediction_of(const motion::FreeBody& body, const motion::Tilt& tilt,
                          scene::Language language) {
  const body::PrincipalAxes& principal = body.principal();
  if (body.is_rigid()) {
    const double rate = tilt.steady_rate();
    return scene::course_of_tilt(motion::stability(principal.moments, tilt.axis(), rate), rate,
                                 language);
  }
  return scene::Phrase("of {}", "av {}")
      .in(language, scene::axis_name(principal.axes, tilt.axis()));
}

/// Round-off does not change the text from frame to frame: it is rounded up where it lies half way
/// between two.
std::string degrees_text(double tilt) {
  if (tilt < angle_round_off) return "0°";
  const double value = tilt / degree * (1 + 1e-9);
  if (value < 1e-3) return hud_text::error(value) + "°";
  return fmt::format("{:.{}f}°", value, value < 0.1 ? 3 : value < 1 ? 2 : value < 10 ? 1 : 0);
}

}  // namespace

TiltPanel::TiltPanel(const scene::Scene& scene, const std::vector<timeline::Solution>& solutions,
                     const Layout& layout, const canvas::Typeface& typeface,
                     const OverlayColors& colors)
    : colors_(colors),
      typeface_(typeface),
      tilt_(solutions[0].body),
      duration_(scene.motion.duration),
      size_(layout.text.caption),
      value_size_(std::max(value_em * size_,
                           least_value / 1080 * std::min(scene.film.width, scene.film.height))),
      thickness_(std::max(1.0, 0.12 * size_)),
      scale_{bottom_of(tilt_, solutions[0].whole), greatest_tilt, {}, size_} {
  const image::Area area = panel_content(*layout.tilt, size_);
  place_plot(area);
  future_ = layer_around(*layout.tilt, 0, {0, 0, scene.film.width, scene.film.height});
  canvas::Canvas future(future_.image, future_.x, future_.y);
  draw_panel(future, *layout.tilt, size_, colors);
  const canvas::Line name = canvas::typeset(
      typeface.regular, scene::Phrase("tilt against L", "helling mot L").in(scene.language));
  future.text(name, size_, {static_cast<double>(area.x), value_.y}, {colors.text});
  const std::string prediction = prediction_of(solutions[0].body, tilt_, scene.language);
  future.text(canvas::typeset_within(typeface.regular, prediction, area.width / size_), size_,
              {static_cast<double>(area.x), value_.y + AngleScale::line_height * size_},
              {colors.dim});
  scale_.draw(future, typeface.regular, colors);
  past_ = future_;
  canvas::Canvas past(past_.image, past_.x, past_.y);
  std::vector<Point> points;
  for (const motion::Sample& sample : solutions[0].whole) {
    points.push_back(place(sample.t, tilt_.from_start(sample)));
  }
  past.polyline(points, thickness_, {colors.text});
  draw_prediction(future, faint_future);
  draw_prediction(past, 1);
  marks_ = marks_of(solutions[0].whole, factor_);
  if (!are_dense(marks_)) return;
  factor_ = 10;
  marks_ = marks_of(solutions[0].whole, factor_);
}

void TiltPanel::place_plot(const image::Area& area) {
  const int left = area.x + static_cast<int>(AngleScale::number_width * size_);
  const int top = area.y + static_cast<int>(2.5 * AngleScale::line_height * size_);
  const int margin = static_cast<int>(0.5 * size_);
  scale_.plot = {left, top, area.x + area.width - left - margin,
                 area.y + area.height - top - margin};
  value_ = {static_cast<double>(area.x + area.width - margin), area.y + 0.95 * size_};
}

Point TiltPanel::place(double time, double tilt) const {
  return {scale_.plot.x + time / duration_ * scale_.plot.width, scale_.y(tilt)};
}

/// Returns the times at which the tilt first reaches its value at the start, or the bottom of the
/// scale, times each power of the factor.
std::vector<TiltPanel::Mark> TiltPanel::marks_of(const std::vector<motion::Sample>& whole,
                                                 double factor) const {
  std::vector<Mark> marks;
  const auto value = [&](const motion::Sample& sample) {
    return std::max(tilt_.from_start(sample), scale_.least);
  };
  double level = factor * value(whole.front());
  for (std::size_t i = 1; i < whole.size(); ++i) {
    const double before = value(whole[i - 1]), after = value(whole[i]);
    for (; level <= after && level < greatest_tilt; level *= factor) {
      const double share = std::log(level / before) / std::log(after / before);
      marks.push_back({std::lerp(whole[i - 1].t, whole[i].t, share), level});
    }
  }
  return marks;
}

bool TiltPanel::are_dense(const std::vector<Mark>& marks) const {
  const auto is_near = [&](const Mark& one, const Mark& next) {
    return place(next.time, 0).x - place(one.time, 0).x < least_gap_em * size_;
  };
  return std::ranges::adjacent_find(marks, is_near) != marks.end();
}

/// Draws the marks up to a time: ticks on the time axis and dots on the curve. The last one has the
/// factor beside it.
void TiltPanel::draw_marks(canvas::Canvas& canvas, double until) const {
  const double bottom = scale_.plot.y + scale_.plot.height;
  const auto end = std::ranges::upper_bound(marks_, until, {}, &Mark::time);
  for (const auto& [time, tilt] : std::span(marks_.begin(), end)) {
    const Point at = place(time, tilt);
    canvas.rectangle(at.x - thickness_ / 2, bottom - tick_em * size_, thickness_, tick_em * size_,
                     {colors_.text});
    canvas.disc(at, 1.4 * thickness_, {colors_.momentum});
  }
  if (end == marks_.begin()) return;
  const Point last = place(std::prev(end)->time, 0);
  canvas.text(canvas::typeset(typeface_.regular, fmt::format("×{}", factor_)), size_,
              {last.x + 0.3 * size_, bottom - 0.15 * size_}, {colors_.text});
}

/// Draws the predicted line, dashed, from t = 0 to where it leaves the plot.
void TiltPanel::draw_prediction(canvas::Canvas& canvas, double opacity) const {
  const auto growth = tilt_.growth();
  if (!growth || !(growth->amplitude > 0)) return;
  const auto leaves = [&](double tilt) {
    return std::log(tilt / growth->amplitude) / growth->rate;
  };
  const double from = std::max(0.0, leaves(scale_.least)),
               to = std::min(leaves(greatest_tilt), duration_);
  if (!(from < to)) return;
  const auto at = [&](double time) {
    return place(time, growth->amplitude * std::exp(growth->rate * time));
  };
  const Point first = at(from), last = at(to);
  const double length = std::hypot(last.x - first.x, last.y - first.y);
  const double step = dash_em * size_;
  for (double along = 0; along < length; along += 2 * step) {
    const auto point = [&](double px) -> Point {
      const double share = std::min(px / length, 1.0);
      return {first.x + share * (last.x - first.x), first.y + share * (last.y - first.y)};
    };
    canvas.polyline(std::array{point(along), point(along + step)}, 0.8 * thickness_,
                    {colors_.momentum, opacity});
  }
}

std::vector<Layer> TiltPanel::draw(const timeline::FrameState& state) {
  Layer layer = future_;
  const motion::Sample& sample = state.solutions[0].sample;
  const double tilt = tilt_.from_start(sample);
  const Point now = place(std::clamp(sample.t, 0.0, duration_), tilt);
  const int margin = static_cast<int>(std::ceil(thickness_));  // of the curve beyond the plot
  const int left = scale_.plot.x - margin;
  copy_area(past_, layer,
            {left, scale_.plot.y - margin, static_cast<int>(std::lround(now.x)) - left,
             scale_.plot.height + 2 * margin});
  canvas::Canvas canvas(layer.image, layer.x, layer.y);
  draw_marks(canvas, sample.t);
  canvas.disc(now, 2 * thickness_, {colors_.text});
  canvas.text(canvas::typeset(typeface_.regular, degrees_text(tilt)), value_size_, value_,
              {colors_.text}, canvas::Canvas::Align::right);
  std::vector<Layer> layers;
  layers.push_back(std::move(layer));
  return layers;
}

}  // namespace twrench::picture
