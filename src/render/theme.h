#pragma once

#include <array>
#include <optional>

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
  Color plane;  ///< the invariable plane
  /// X row by row: a column has its axis' hue, a row its lightness. Those of a row are told apart.
  std::array<Color, 9> curve;
};

/// What lies behind: from the top of the picture to its foot, and stars.
struct Backdrop {
  Color above;
  Color below;
  double vignette;  ///< how much darker the sides are, 0 to 1
  int stars;        ///< how many
};

struct FloorStyle {
  Color light;        ///< what the pool adds at its middle
  double shadow;      ///< of the light, how much the deepest shadow takes: 0 to 1
  double reflection;  ///< of the body's mirror image, how much is seen: 0 to 1
};

struct ThemeStyle {
  Color metal;  ///< or paint: the body, where the scene says nothing else
  double metallic;
  double roughness;
  Studio studio;
  Backdrop backdrop;
  std::optional<FloorStyle> floor;  ///< none: the body floats in space
  OverlayColors overlay;
};

const ThemeStyle& style_of(Theme theme);

}  // namespace twrench
