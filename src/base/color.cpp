#include "base/color.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include <algorithm>
#include <charconv>

namespace twrench {

Color parse_color(const std::string& text, const std::string& what) {
  if (text == "black") return {0, 0, 0};
  if (text == "gray") return {128, 128, 128};
  if (text == "white") return {255, 255, 255};
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
