#pragma once

#include <array>

#include "render/studio.h"
#include "scene/scene.h"

namespace twrench {

/// What is laid over the body is drawn in these. Text in `text` or `dim` can be read anywhere on
/// the theme's background, and on a panel; the colours that tell things apart can be read as text
/// on a panel and, but for the brightest pool of light, on the background: a contrast of 4.5 at
/// least (WCAG 2.1, 1.4.3). Viewers of all kinds of colour vision can tell them apart.
struct OverlayColors {
  Color text;
  Color dim;  ///< of what is said by the way: units, grid lines, the future of a curve
  Color panel;
  double panel_opacity;       ///< 0 to 1
  std::array<Color, 3> axis;  ///< the body's x, y, z
  Color momentum;             ///< L
  Color omega;
  Color trail;
  Color plane;                 ///< the invariable plane
  std::array<Color, 9> curve;  ///< X row by row: a column has its axis' hue, a row its lightness
};

/// What lies behind, all sRGB: dark to bright from top to floor, a pool of light, stars.
struct Backdrop {
  Color above;
  Color floor;
  Color pool;  ///< at its middle
  int stars;   ///< how many to a picture of 16:9
};

struct ThemeStyle {
  Color metal;  ///< or paint: the body, where the scene says nothing else
  double metallic;
  double roughness;
  Studio studio;
  Backdrop backdrop;
  OverlayColors overlay;
};

const ThemeStyle& style_of(Theme theme);

}  // namespace twrench
