#pragma once

#include <twrench/motion/free_body.h>

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "picture/views/principal_frame.h"

namespace twrench::picture {

/// The curves of constant energy on the sphere of momenta of length |L|, as points on the unit
/// sphere along the axes of a PrincipalFrame.
struct SphereCurves {
  using Curve = std::vector<Eigen::Vector3d>;

  struct Level {
    Curve curve;
    std::size_t axis;  ///< Index of the principal axis that it circles.
  };
  /// Levels that cover the sphere.
  std::vector<Level> levels;
  /// The curve on which the momentum moves; empty if it moves on none, or rests.
  Curve path;
  /// The curves that separate regions of levels.
  std::vector<Curve> separatrices;
  /// Directions in which the momentum of a body with a wheel rests. Those of a rigid body are its
  /// axes.
  Curve equilibria;
};

/// Returns the curves of a body; none for one with a wheel and L = 0.
SphereCurves sphere_curves(const motion::FreeBody& body, const PrincipalFrame& frame);

}  // namespace twrench::picture
