#pragma once

#include <twrench/motion/free_body.h>
#include <twrench/motion/polhode.h>

#include <array>
#include <optional>
#include <string>

#include "picture/look/theme.h"

namespace twrench::picture {

/// The body's principal axes as the momentum views show them, least moment first.
struct PrincipalFrame {
  PrincipalFrame(const motion::FreeBody& body, const OverlayColors& colors);

  /// Rotation body_from_own. Each axis has a positive largest component, so the axes may be
  /// left-handed.
  Eigen::Matrix3d axes;
  /// The body axis' colour, if the principal axis coincides with one.
  std::array<Color, 3> colors;
  /// Likewise x, y or z; otherwise I1, I2, I3.
  std::array<std::string, 3> names;
  /// The energy level of the momentum.
  std::optional<motion::EnergyLevel> level;
  /// Direction of the momentum at t = 0; 0 at rest.
  Eigen::Vector3d direction;
};

/// Returns the visibility of a point on a closed convex surface seen from `eye`: 1 on the near
/// side, less on the far side, with a ramp at the silhouette. `outward` is the surface normal.
double shown(const Eigen::Vector3d& place, const Eigen::Vector3d& outward,
             const Eigen::Vector3d& eye);

}  // namespace twrench::picture
