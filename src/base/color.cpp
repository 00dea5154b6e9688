#include "base/color.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include <array>
#include <charconv>

namespace twrench {

namespace {

struct NamedColor {
  const char* name;
  Color color;
};

constexpr std::array named_colors{NamedColor{"black", {0, 0, 0}},
                                  NamedColor{"gray", {128, 128, 128}},
                                  NamedColor{"white", {255, 255, 255}}};

}  // namespace

std::vector<std::string> color_names() {
  std::vector<std::string> names;
  for (const NamedColor& named : named_colors) names.emplace_back(named.name);
  return names;
}

Color parse_color(const std::string& text, const std::string& what) {
  for (const auto& [name, color] : named_colors) {
    if (text == name) return color;
  }
  std::string digits = text.substr(text.empty() ? 0 : 1);
  if (digits.size() == 3) {
    digits = {digits[0], digits[0], digits[1], digits[1], digits[2], digits[2]};
  }
  unsigned value = 0;
  const char* const end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, value, 16);
  if (text[0] != '#' || digits.size() != 6 || error != std::errc{} || stop != end) {
    throw InvalidArgument(what, fmt::format("'{}' is not a colour", text),
                          "write #rrggbb, #rgb, black, gray or white");
  }
  return {static_cast<int>(value >> 16), static_cast<int>(value >> 8 & 0xff),
          static_cast<int>(value & 0xff)};
}

std::string to_string(const Color& color) {
  return fmt::format("#{:02x}{:02x}{:02x}", color.red, color.green, color.blue);
}

}  // namespace twrench
