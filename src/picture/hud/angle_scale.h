#pragma once

#include <numbers>

#include "canvas/canvas.h"
#include "canvas/typesetting.h"
#include "picture/compose/layout.h"
#include "picture/look/theme.h"

namespace twrench::picture {

inline constexpr double degree = std::numbers::pi / 180;  // rad

/// Angles below this one, in rad, are only round-off.
inline constexpr double angle_round_off = 1e-9 * degree;

/// The logarithmic scale of a plot of angles.
struct AngleScale {
  static constexpr double number_width = 2.6, line_height = 1.5;  ///< em; of the line above

  double least, greatest;  ///< rad: powers of ten in degrees, or 180 degrees
  image::Area plot;
  double size;  ///< of its numbers, px per em

  /// Returns the position in the picture, in px, of an angle in rad; others than the scale's are
  /// drawn at its ends.
  double y(double angle) const;

  /// Draws a line and, at the left, a number for each decade, as far as there is room, and for 180
  /// degrees.
  void draw(canvas::Canvas& canvas, const canvas::Font& font, const OverlayColors& colors) const;
};

/// Returns the power of ten in degrees that is at most `angle`, in rad.
double decade_below(double angle);

}  // namespace twrench::picture
