#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "body/shape.h"

namespace twrench {

/// All points within `radius` of a segment. Lengths in cm, body axes.
struct Capsule {
  Eigen::Vector3d from, to;
  double radius;
  bool meets = false;  ///< a cylinder that is drawn before the part whose neighbour it is
};

/// The capsule that takes about the place of the part, for shade that is soft anyway: about its
/// longest axis, its ends drawn in by half a radius.
Capsule capsule_of(const Part& part);

/// For each part, the capsules of the nearest others that are near enough to shade it: the nearest
/// first, at most `most`.
std::vector<std::vector<Capsule>> neighbours(std::span<const Part> parts, std::size_t most);

}  // namespace twrench
