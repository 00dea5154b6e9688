#include "picture/hud/hud_text.h"

#include <fmt/format.h>
#include <twrench/math/so3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "scene/phrase.h"

namespace twrench::picture::hud_text {
namespace {

constexpr const char* thin_space = "\u2009";
constexpr const char* below_round_off = "<10⁻¹⁴";

std::string raised(int exponent) {
  static constexpr std::array digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text;
  for (const char c : std::to_string(exponent)) {
    text += c == '-' ? "⁻" : digits[static_cast<std::size_t>(c - '0')];
  }
  return text;
}

/// Returns "1.2e-15" as "1.2×10⁻¹⁵".
std::string typographic(const std::string& number) {
  const std::size_t e = number.find('e');
  if (e == std::string::npos) return number;
  return number.substr(0, e) + "×10" + raised(std::stoi(number.substr(e + 1)));
}

/// Groups the digits before the decimal point by three if there are many.
std::string grouped(const std::string& number) {
  std::string text;
  const std::size_t whole = std::min(number.find('.'), number.size());
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (whole > 4 && i > 0 && i < whole && (whole - i) % 3 == 0) text += thin_space;
    text += number[i];
  }
  return text;
}

}  // namespace

std::string time(double t, double resolution, const TimeUnit& unit) {
  const double wanted = std::ceil(-std::log10(resolution / unit.length) - 1e-9);
  const auto decimals = static_cast<int>(std::clamp(wanted, 0.0, 3.0));
  return grouped(fmt::format("{:.{}f}", t / unit.length, decimals)) + " " + unit.symbol;
}

std::string rounded_time(double t, const TimeUnit& unit) {
  const double value = t / unit.length;
  return value < 1000 ? fmt::format("{:.3g} {}", value, unit.symbol)
                      : fmt::format("{:.0f} {}", value, unit.symbol);
}

std::string error(double value) {
  const double size = std::abs(value);
  if (size < round_off) return below_round_off;
  if (size >= 0.00995 && size < 99.5) {  // as rounded to two digits: from 0.010 to 99
    const int decimals = size < 0.0995 ? 3 : size < 0.995 ? 2 : size < 9.95 ? 1 : 0;
    return fmt::format("{:.{}f}", size, decimals);
  }
  return typographic(fmt::format("{:.1e}", size));
}

std::string drift(double value) {
  if (std::abs(value) < round_off) return below_round_off;
  return (value < 0 ? "−" : "+") + error(value);
}

std::string degrees(const motion::Sample& from, const motion::Sample& to) {
  const double angle = so3::log(from.X.transpose() * to.X).norm() * 180 / std::numbers::pi;
  return angle < 0.005 ? "<0.01°" : fmt::format("{:.{}f}°", angle, angle < 9.995 ? 2 : 1);
}

std::string setting(double value) {
  const std::string text = fmt::format("{:.4g}", value);
  return text.starts_with("1e") ? power_of_ten(std::stoi(text.substr(2))) : typographic(text);
}

std::string power_of_ten(int exponent) { return "10" + raised(exponent); }

std::string method(const timeline::Solution& solution, scene::Language language) {
  using scene::Phrase;
  if (solution.recording) return Phrase("recorded", "målt").in(language);
  const std::string_view name = solution.method->name;
  if (solution.method->exact()) {
    return Phrase("{}, closed form", "{}, lukket form").in(language, name);
  }
  return solution.method->adaptive() ? Phrase("{}, tolerance {}", "{}, toleranse {}")
                                           .in(language, name, setting(solution.control.tolerance))
                                     : Phrase("{}, step {} s", "{}, steg {} s")
                                           .in(language, name, setting(solution.control.step));
}

}  // namespace twrench::picture::hud_text
