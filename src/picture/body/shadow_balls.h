#pragma once

#include <twrench/body/shape.h>

#include <Eigen/Core>
#include <span>
#include <vector>

#include "picture/body/occluders.h"

namespace twrench::picture {

/// A sphere that casts shadow; a part is approximated by rows of them.
struct Ball {
  Eigen::Vector3d centre;  ///< Centre in cm, body axes.
  double radius;           ///< Radius in cm.
};

/// Returns spheres along the axis of a capsule at such distances that they cast as much shadow as
/// it.
std::vector<Ball> shadow_balls(const Capsule& capsule);

/// Returns those of all capsules of the parts.
std::vector<Ball> shadow_balls(std::span<const body::Part> parts);

}  // namespace twrench::picture
