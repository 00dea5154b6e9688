#pragma once

#include <twrench/motion/free_body.h>

#include <Eigen/Core>
#include <cstddef>
#include <optional>
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

/// A region of the unit sphere about the end of an axis, as points along the axes of a
/// PrincipalFrame.
struct Cap {
  Eigen::Vector3d middle;
  SphereCurves::Curve rim;  ///< The last point is the first.
};

/// Returns the cap whose area is the geometric phase of a rigid body (docs/theory.md, "The
/// geometric phase"): that inside the path of the momentum. Nothing if the momentum rests, or if
/// its path does not close.
std::optional<Cap> phase_cap(const motion::FreeBody& body, const PrincipalFrame& frame);

/// Returns the curves of a body; none for one with a wheel and L = 0.
SphereCurves sphere_curves(const motion::FreeBody& body, const PrincipalFrame& frame);

}  // namespace twrench::picture
