#pragma once

#include <twrench/body/shape.h>

#include <span>

namespace twrench::picture {

/// Returns a bounding radius in cm of the parts about the origin. It is the smallest one, but may
/// be larger for an ellipsoid that is neither a sphere nor at the origin.
double bounding_radius(std::span<const body::Part> parts);

/// Returns how far the part extends from the origin along a unit vector, in cm.
double extent_along(const body::Part& part, const Eigen::Vector3d& direction);

}  // namespace twrench::picture
