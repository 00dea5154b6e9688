#include "picture/hud/torque_gauge.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "picture/hud/hud_text.h"
#include "picture/hud/panel.h"
#include "picture/look/force_style.h"
#include "scene/phrase.h"

namespace twrench::picture {
namespace {

using Point = canvas::Canvas::Point;
using Align = canvas::Canvas::Align;

// Lengths in em of the text.
constexpr double heading_line = 0.75, gauge_top = 1.25, gauge_thickness = 0.6,
                 value_below_bar = 1.15, names_below_value = 1.15, marker_width = 0.5,
                 marker_overhang = 0.15, side_gap = 0.4;
constexpr double gauge_margin = 1.04;  // the largest torque is inside the bar
constexpr double empty_opacity = 0.3;
constexpr double unit_width = 0.4;  // of the bar

}  // namespace

TorqueGauge::TorqueGauge(const scene::Scene& scene,
                         const std::vector<timeline::Solution>& solutions, const Layout& layout,
                         const canvas::Typeface& typeface, const OverlayColors& colors)
    : colors_(colors),
      typeface_(typeface),
      torque_(scene, solutions[0].body),
      size_(torque_text_size(layout.text)),
      strongest_(torque_.strongest(solutions[0].whole)),
      ground_(layer_around(*layout.torques, 0, {0, 0, scene.film.width, scene.film.height})) {
  if (strongest_ > 0) {
    const int digits = static_cast<int>(std::floor(std::log10(strongest_)));
    if (digits < -2 || digits > 4) exponent_ = digits;
    decimals_ = std::clamp(2 - (digits - exponent_), 0, 4);
  }
  const image::Area area = panel_content(*layout.torques, size_);
  bar_ = {area.x, area.y + static_cast<int>(gauge_top * size_), area.width,
          static_cast<int>(gauge_thickness * size_)};
  value_line_ = bar_.y + bar_.height + value_below_bar * size_;
  canvas::Canvas canvas(ground_.image, ground_.x, ground_.y);
  draw_panel(canvas, *layout.torques, size_, colors);
  name_width_ = area.width / 2.0 / size_ - side_gap;
  const double right = area.x + area.width, line = area.y + heading_line * size_;
  const auto write = [&](const std::string& text, double x, double y, const Color& color,
                         Align align) {
    canvas.text(canvas::typeset(typeface.regular, text), size_, {x, y}, {color}, align);
  };
  write(scene::Phrase("tilts back", "tipper tilbake").in(scene.language), area.x, line,
        color_of_back(colors), Align::left);
  write(scene::Phrase("tilts further", "tipper videre").in(scene.language), right, line,
        color_of_further(colors), Align::right);
  const std::string power = exponent_ == 0 ? "" : hud_text::setting(std::pow(10, exponent_)) + " ";
  const std::string unit =
      scene::Phrase("torque, {}dyn cm", "dreiemoment, {}dyn cm").in(scene.language, power);
  canvas.text(canvas::typeset_within(typeface.regular, unit, unit_width * area.width / size_),
              size_, {area.x + area.width / 2.0, line}, {colors.dim}, Align::centre);
  canvas.rectangle(bar_.x, bar_.y, bar_.width, bar_.height, {colors.dim, empty_opacity});
}

double TorqueGauge::place(double torque) const {
  const double middle = bar_.x + bar_.width / 2.0;
  if (!(strongest_ > 0)) return middle;
  return middle + bar_.width / 2.0 * std::clamp(torque / (gauge_margin * strongest_), -1.0, 1.0);
}

std::string TorqueGauge::text(double torque) const {
  const std::string number =
      fmt::format("{:.{}f}", std::abs(torque) / std::pow(10, exponent_), decimals_);
  const bool is_zero = number.find_first_not_of("0.") == std::string::npos;
  return (is_zero ? "" : torque < 0 ? "−" : "+") + number;
}

std::vector<Layer> TorqueGauge::draw(const timeline::FrameState& state) {
  const motion::Sample& sample = state.solutions[0].sample;
  const timeline::TiltingTorque::Sides sides =
      strongest_ > 0 ? torque_.sides(sample) : timeline::TiltingTorque::Sides{};
  const auto [further, back] = torque_.names(sample);
  Layer layer = ground_;
  canvas::Canvas canvas(layer.image, layer.x, layer.y);
  draw_side(canvas, sides.back, back, Align::left);
  draw_side(canvas, sides.further, further, Align::right);
  const double x = place(sides.sum()), top = bar_.y - marker_overhang * size_,
               bottom = bar_.y + bar_.height + marker_overhang * size_;
  canvas.polyline(std::array{Point{x, top}, Point{x, bottom}}, marker_width * size_,
                  {colors_.panel});
  canvas.polyline(std::array{Point{x, top}, Point{x, bottom}}, 0.5 * marker_width * size_,
                  {colors_.text});
  const std::string sum = "sum " + text(sides.sum());  // so in both languages
  canvas.text(canvas::typeset(typeface_.regular, sum), size_, {place(0), value_line_},
              {colors_.text}, Align::centre);
  std::vector<Layer> layers;
  layers.push_back(std::move(layer));
  return layers;
}

/// Draws the bar and the value of a torque, and the names of its groups below the value.
void TorqueGauge::draw_side(canvas::Canvas& canvas, double torque, const std::string& names,
                            Align align) const {
  const bool is_left = align == Align::left;
  const canvas::Canvas::Ink ink{is_left ? color_of_back(colors_) : color_of_further(colors_)};
  const double middle = place(0), end = place(torque);
  canvas.rectangle(std::min(middle, end), bar_.y, std::abs(end - middle), bar_.height, ink);
  const canvas::Line value = canvas::typeset(typeface_.regular, text(torque));
  const double edge = is_left ? bar_.x : bar_.x + bar_.width;
  canvas.text(value, size_, {edge, value_line_}, ink, align);
  canvas.text(canvas::typeset_within(typeface_.regular, names, name_width_), size_,
              {edge, value_line_ + names_below_value * size_}, ink, align);
}

}  // namespace twrench::picture
