#pragma once

#include <string>

namespace twrench {

/// A colour as users write it: sRGB, each channel from 0 to 255.
struct Color {
  int red, green, blue;
  bool operator==(const Color&) const = default;
};

/// Parses "#rrggbb", "#rgb", "black", "gray" or "white". Throws InvalidArgument about `what`.
Color parse_color(const std::string& text, const std::string& what);

/// Returns the colour as "#rrggbb".
std::string to_string(const Color& color);

}  // namespace twrench
