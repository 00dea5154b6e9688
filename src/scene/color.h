#pragma once

#include <string>

namespace twrench {

/// A colour as people write it: sRGB, each 0 to 255.
struct Color {
  int red, green, blue;
  bool operator==(const Color&) const = default;
};

/// "#rrggbb", "#rgb", or black, gray, white. Throws UsageError about `what`.
Color parse_color(const std::string& text, const std::string& what);

/// "#rrggbb"
std::string to_string(const Color& color);

}  // namespace twrench
