#include "render/look/theme.h"

#include <cmath>

namespace twrench::render {
namespace {

/// Interpolates from a to b, each channel by `share`.
scene::Color mixed(const scene::Color& a, const scene::Color& b, double share) {
  const auto channel = [&](int from, int to) {
    return static_cast<int>(std::lround(from + share * (to - from)));
  };
  return {channel(a.red, b.red), channel(a.green, b.green), channel(a.blue, b.blue)};
}

/// The axes' colours for the columns; rows from near `first` to near `last`.
std::array<scene::Color, 9> curves(const std::array<scene::Color, 3>& axis,
                                   const scene::Color& first, const scene::Color& last) {
  std::array<scene::Color, 9> result{};
  for (std::size_t column = 0; column < 3; ++column) {
    result[column] = mixed(axis[column], first, 0.3);
    result[3 + column] = axis[column];
    result[6 + column] = mixed(axis[column], last, 0.18);
  }
  return result;
}

// The distinguishing colours started as those of Okabe and Ito ("Color Universal Design", 2008).
// Subject to the contrast that text needs, they were moved to maximise the smallest difference
// between any two for normal, protan, deutan and tritan vision (Machado et al. 2009).

OverlayColors on_dark() {
  const std::array<scene::Color, 3> axis{{{213, 114, 53}, {9, 213, 139}, {85, 139, 247}}};
  return {.text = {245, 247, 250},
          .dim = {216, 220, 228},
          .panel = {14, 16, 21},
          .panel_opacity = 0.8,
          .axis = axis,
          .momentum = {236, 213, 74},
          .omega = {255, 149, 225},
          .trail = {255, 255, 255},
          .plane = {131, 146, 157},
          .curve = curves(axis, {255, 255, 255}, {0, 0, 0})};
}

OverlayColors on_paper() {
  const std::array<scene::Color, 3> axis{{{185, 73, 15}, {1, 125, 89}, {0, 42, 205}}};
  return {.text = {16, 18, 22},
          .dim = {70, 74, 82},
          .panel = {255, 255, 255},
          .panel_opacity = 0.78,
          .axis = axis,
          .momentum = {102, 24, 0},
          .omega = {132, 21, 143},
          .trail = {0, 0, 0},
          .plane = {103, 93, 121},
          .curve = curves(axis, {0, 0, 0}, {255, 255, 255})};
}

constexpr scene::Color steel{184, 188, 196};

ThemeStyle studio() {
  return {.metal = steel,
          .metallic = 1,
          .roughness = 0.34,
          .studio = dark_studio(),
          .backdrop = {{9, 10, 13}, {46, 49, 57}, 0.22, 0},
          .floor = FloorStyle{{44, 44, 44}, 0.7, 0.16},
          .overlay = on_dark()};
}

ThemeStyle paper() {
  return {.metal = {168, 172, 180},
          .metallic = 1,
          .roughness = 0.34,
          .studio = white_studio(),
          .backdrop = {{250, 250, 249}, {236, 236, 234}, 0.02, 0},
          .floor = FloorStyle{{16, 16, 16}, 0.42, 0.10},
          .overlay = on_paper()};
}

ThemeStyle space() {
  return {.metal = steel,
          .metallic = 1,
          .roughness = 0.34,
          .studio = sunlight(),
          .backdrop = {{3, 4, 7}, {7, 9, 15}, 0.2, 420},
          .floor = std::nullopt,
          .overlay = on_dark()};
}

}  // namespace

const ThemeStyle& style_of(scene::Theme theme) {
  static const std::array<ThemeStyle, 3> styles{studio(), paper(), space()};
  return styles[static_cast<std::size_t>(theme)];
}

}  // namespace twrench::render
