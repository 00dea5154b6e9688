#include "picture/look/theme.h"

#include <array>
#include <cmath>
#include <map>

#include "base/enumeration.h"

namespace twrench::picture {
namespace {

/// Interpolates from a to b, each channel by `share`.
Color mixed(const Color& a, const Color& b, double share) {
  const auto channel = [&](int from, int to) {
    return static_cast<int>(std::lround(from + share * (to - from)));
  };
  return {channel(a.red, b.red), channel(a.green, b.green), channel(a.blue, b.blue)};
}

/// Columns have the axes' colours; rows range from a colour close to `end` to the axes' colours
/// themselves.
std::array<Color, 9> curves(const std::array<Color, 3>& axis, const Color& end) {
  std::array<Color, 9> result{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      result[3 * row + column] = mixed(axis[column], end, 0.4 - 0.2 * static_cast<double>(row));
    }
  }
  return result;
}

// The distinguishing colours started as those of Okabe and Ito ("Color Universal Design", 2008).
// Subject to the contrast that text needs on a panel over any background, they were moved to
// maximise the smallest difference between any two for normal, protan, deutan and tritan vision
// (Machado et al. 2009), also where an arrow is in shade, at 0.65 of its colour. Those of the
// forces differ from one another in the same way, and from those of the axes at least for normal
// vision.

OverlayColors on_dark() {
  const std::array<Color, 3> axis{{{243, 82, 49}, {0, 248, 151}, {118, 124, 255}}};
  return {.text = {245, 247, 250},
          .dim = {216, 220, 228},
          .panel = {14, 16, 21},
          .panel_opacity = 0.92,
          .axis = axis,
          .momentum = {255, 216, 39},
          .omega = {247, 120, 201},
          .force = {{{51, 204, 255}, {210, 138, 40}, {204, 85, 255}}},
          .trail = {255, 255, 255},
          .plane = {116, 126, 132},
          .curve = curves(axis, {255, 255, 255})};
}

OverlayColors on_white() {
  const std::array<Color, 3> axis{{{199, 43, 5}, {0, 118, 100}, {32, 7, 231}}};
  return {.text = {16, 18, 22},
          .dim = {70, 74, 82},
          .panel = {255, 255, 255},
          .panel_opacity = 0.92,
          .axis = axis,
          .momentum = {114, 0, 0},
          .omega = {143, 56, 178},
          .force = {{{0, 102, 187}, {153, 85, 34}, {85, 0, 102}}},
          .trail = {0, 0, 0},
          .plane = {76, 58, 103},
          .curve = curves(axis, {0, 0, 0})};
}

constexpr PageColors dark_page{.is_light = false,
                               .ground = {11, 13, 18},
                               .panel = {20, 23, 30},
                               .raised = {31, 35, 45},
                               .line = {59, 65, 80},
                               .control = {134, 142, 160},
                               .dim = {195, 201, 212},
                               .on_momentum = {20, 18, 10},
                               .warning = {255, 180, 160}};

constexpr PageColors white_page{.is_light = true,
                                .ground = {244, 244, 241},
                                .panel = {255, 255, 255},
                                .raised = {238, 238, 234},
                                .line = {207, 207, 201},
                                .control = {112, 116, 124},
                                .dim = {70, 74, 82},
                                .on_momentum = {255, 255, 255},
                                .warning = {140, 29, 0}};

PageColors black_page() {
  PageColors colors = dark_page;
  colors.ground = {2, 3, 6};
  colors.panel = {12, 14, 20};
  colors.raised = {24, 27, 36};
  return colors;
}

constexpr Color steel{184, 188, 196};

ThemeStyle studio() {
  return {.metal = steel,
          .metallic = 1,
          .roughness = 0.25,
          .studio = dark_studio(),
          .backdrop = {{11, 13, 20}, {45, 47, 54}, 0.16, 0},
          .floor = FloorStyle{{49, 49, 49}, 0.66, 0.18, 0.14},
          .overlay = on_dark(),
          .page = dark_page};
}

ThemeStyle paper() {
  return {.metal = {168, 172, 180},
          .metallic = 1,
          .roughness = 0.25,
          .studio = white_studio(),
          .backdrop = {{250, 250, 248}, {237, 237, 235}, 0.02, 0},
          .floor = FloorStyle{{16, 16, 16}, 0.50, 0.10, 0.03},
          .overlay = on_white(),
          .page = white_page};
}

ThemeStyle space() {
  return {.metal = steel,
          .metallic = 1,
          .roughness = 0.25,
          .studio = sunlight(),
          .backdrop = {{3, 4, 8}, {8, 9, 13}, 0.2, 420},
          .floor = std::nullopt,
          .overlay = on_dark(),
          .page = black_page()};
}

struct ThemeRow {
  scene::Theme theme;
  ThemeStyle (*make_style)();
};
constexpr std::array theme_rows{ThemeRow{scene::Theme::studio, studio},
                                ThemeRow{scene::Theme::paper, paper},
                                ThemeRow{scene::Theme::space, space}};
static_assert(has_row_for_each(theme_rows, &ThemeRow::theme));

std::map<scene::Theme, ThemeStyle> make_styles() {
  std::map<scene::Theme, ThemeStyle> styles;
  for (const auto& [theme, make_style] : theme_rows) styles.emplace(theme, make_style());
  return styles;
}

}  // namespace

const ThemeStyle& style_of(scene::Theme theme) {
  static const std::map<scene::Theme, ThemeStyle> styles = make_styles();
  return styles.at(theme);
}

}  // namespace twrench::picture
