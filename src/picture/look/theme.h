#pragma once

#include <array>
#include <optional>

#include "picture/look/studio.h"
#include "scene/scene.h"

namespace twrench::picture {

/// The colours of overlays. All are legible as text on a panel over any background, and `text` and
/// `dim` anywhere on the theme's background too: the contrast is at least 4.5 (WCAG 2.1, 1.4.3).
/// They are distinguishable with every type of colour vision.
struct OverlayColors {
  /// Text.
  Color text;
  /// For secondary content: units, grid lines, the future of a curve.
  Color dim;
  /// Panels behind text and curves.
  Color panel;
  /// 0 to 1.
  double panel_opacity;
  /// The body's x, y and z axes.
  std::array<Color, 3> axis;
  /// The angular momentum L.
  Color momentum;
  /// The angular velocity.
  Color omega;
  /// The centrifugal, the Coriolis and the Euler force.
  std::array<Color, 3> force;
  /// The trail of a point.
  Color trail;
  /// The invariable plane.
  Color plane;
  /// The components of X row by row: a column has its axis' hue, a row its lightness. Curves of one
  /// row are distinguishable.
  std::array<Color, 9> curve;
};

/// The background: a vertical gradient, and stars. All its colours have the same differences
/// between their channels, because the 8-bit chroma planes of a video would turn a hue that varies
/// with the brightness into visible contours.
struct Backdrop {
  /// Colour at the top of the picture.
  Color above;
  /// Colour at the bottom of the picture.
  Color below;
  /// Darkening of the sides, 0 to 1.
  double vignette;
  /// Number of stars.
  int stars;
};

/// The floor of a theme.
struct FloorStyle {
  /// Light added in the middle of the pool. It is gray and therefore keeps the hue of the
  /// background.
  Color light;
  /// Fraction of the light that the deepest shadow removes, 0 to 1.
  double shadow;
  /// Visible fraction of the body's mirror image, 0 to 1.
  double reflection;
  /// Fraction of the light that the darkest clouds in its polish remove, 0 to 1. Under a moving
  /// camera they show that the floor stands still.
  double clouds;
};

/// The colours of a web page around the picture, beside the overlays' `text`, `momentum` and
/// `omega`.
struct PageColors {
  /// Whether the browser draws controls and scroll bars for a light page.
  bool is_light;
  /// The page.
  Color ground;
  /// Panels on the page.
  Color panel;
  /// Buttons and fields.
  Color raised;
  /// Lines between panels.
  Color line;
  /// The outlines of buttons and fields.
  Color control;
  /// For secondary content.
  Color dim;
  /// Text on the colour of `momentum`.
  Color on_momentum;
  /// Warnings.
  Color warning;
};

/// Everything that a theme determines.
struct ThemeStyle {
  /// Colour of the body, metal or paint, unless the scene sets it.
  Color metal;
  /// Metalness of the body, 0 (paint) to 1 (metal).
  double metallic;
  /// Surface roughness of the body, 0.05 (mirror) to 1 (chalk).
  double roughness;
  /// Lights.
  Studio studio;
  /// Background.
  Backdrop backdrop;
  /// Nothing if the body floats in space.
  std::optional<FloorStyle> floor;
  /// Colours of overlays.
  OverlayColors overlay;
  /// Colours of a web page.
  PageColors page;
};

const ThemeStyle& style_of(scene::Theme theme);

}  // namespace twrench::picture
