#pragma once

#include <twrench/body/shape.h>

#include <Eigen/Core>
#include <span>
#include <vector>

namespace twrench::picture {

/// A sphere that casts shadow; a part is approximated by rows of them.
struct Ball {
  Eigen::Vector3d centre;  ///< Centre in cm, body axes.
  double radius;           ///< Radius in cm.
};

/// Returns spheres along the axes of the parts' capsules at such distances that they cast as much
/// shadow as the capsules.
std::vector<Ball> shadow_balls(std::span<const body::Part> parts);

}  // namespace twrench::picture
