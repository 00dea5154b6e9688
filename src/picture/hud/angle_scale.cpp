#include "picture/hud/angle_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "picture/hud/hud_text.h"

namespace twrench::picture {
namespace {

constexpr double grid_opacity = 0.22;

int exponent_of(double decade) {
  return static_cast<int>(std::lround(std::log10(decade / degree)));
}

std::string text_of(int exponent) {
  return (exponent > -3 ? fmt::format("{}", std::pow(10, exponent))
                        : hud_text::power_of_ten(exponent)) +
         "°";
}

}  // namespace

double AngleScale::y(double angle) const {
  const double share =
      std::log(greatest / std::clamp(angle, least, greatest)) / std::log(greatest / least);
  return plot.y + share * plot.height;
}

void AngleScale::draw(canvas::Canvas& canvas, const canvas::Font& font,
                      const OverlayColors& colors) const {
  const auto line = [&](double angle, const std::string& text) {
    const double height = std::round(y(angle));
    canvas.rectangle(plot.x, height, plot.width, 1, {colors.dim, grid_opacity});
    canvas.text(canvas::typeset(font, text), size, {plot.x - 0.4 * size, height + 0.35 * size},
                {colors.dim}, canvas::Canvas::Align::right);
  };
  const bool is_whole = greatest == std::numbers::pi;
  if (is_whole) line(greatest, "180°");
  const int first = is_whole ? 1 : exponent_of(greatest), last = exponent_of(least);
  const double apart = y(degree) - y(10 * degree);
  const int every = std::max(1, static_cast<int>(std::ceil(1.2 * size / std::abs(apart))));
  const double free =
      is_whole ? y(greatest) + 1.2 * size : plot.y;  // below the number of 180 degrees
  for (int exponent = first; exponent >= last; exponent -= every) {
    const double angle = std::pow(10, exponent) * degree;
    if (y(angle) >= free) line(angle, text_of(exponent));
  }
}

double decade_below(double angle) {
  return degree * std::pow(10, std::floor(std::log10(angle / degree) + 1e-9));
}

}  // namespace twrench::picture
