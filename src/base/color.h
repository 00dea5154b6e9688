#pragma once

#include <string>
#include <vector>

namespace twrench {

/// A colour in sRGB as users write it, each channel from 0 to 255.
struct Color {
  int red, green, blue;
  bool operator==(const Color&) const = default;
};

/// Returns the names of colours: black, gray and white.
std::vector<std::string> color_names();

/// Parses "#rrggbb", "#rgb" or a name. Throws InvalidArgument about `what`.
Color parse_color(const std::string& text, const std::string& what);

/// Returns the colour as "#rrggbb".
std::string to_string(const Color& color);

}  // namespace twrench
