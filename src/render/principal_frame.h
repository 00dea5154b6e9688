#pragma once

#include <array>
#include <optional>
#include <string>

#include "motion/free_body.h"
#include "motion/polhode.h"
#include "render/theme.h"

namespace twrench {

/// What the views of the momentum know of a body's principal axes, least moment first.
struct PrincipalFrame {
  PrincipalFrame(const FreeBody& body, const OverlayColors& colors);

  Eigen::Matrix3d axes;              ///< body_from_own: each with its greatest component positive,
                                     ///< and so left-handed as often as not
  std::array<Color, 3> colors;       ///< where an axis is one of the body's, that one's
  std::array<std::string, 3> names;  ///< likewise: x, y or z, else I1, I2, I3
  std::optional<EnergyLevel> level;  ///< on which the momentum is
  Eigen::Vector3d direction;         ///< of the momentum, at t = 0; 0 at rest
};

/// How much of what lies on a closed convex surface is to be seen from `eye` through it: 1 on the
/// near side, less on the far one, with a ramp at the outline. `outward` is the surface's normal.
double shown(const Eigen::Vector3d& place, const Eigen::Vector3d& outward,
             const Eigen::Vector3d& eye);

}  // namespace twrench
