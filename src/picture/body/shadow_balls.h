#pragma once

#include <twrench/body/shape.h>

#include <Eigen/Core>
#include <span>
#include <vector>

#include "picture/body/occluders.h"

namespace twrench::picture {

/// A sphere that casts a shadow. Rows of spheres approximate a part.
struct Ball {
  Eigen::Vector3d centre;  ///< Centre in cm, body axes.
  double radius;           ///< Radius in cm.
};

/// Returns spheres along the axis of a capsule, spaced so that they cast as much shadow as the
/// capsule.
std::vector<Ball> shadow_balls(const Capsule& capsule);

/// Returns the spheres of all capsules of the parts.
std::vector<Ball> shadow_balls(std::span<const body::Part> parts);

}  // namespace twrench::picture
