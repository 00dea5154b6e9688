#pragma once

#include <twrench/body/shape.h>

#include <Eigen/Core>
#include <optional>
#include <span>

namespace twrench::render {

/// Returns the axis of a body of revolution, which goes through the origin, as a unit vector in
/// body axes; for a sphere, its own z axis. Nothing for a body that is not one: how far it has
/// turned is visible.
std::optional<Eigen::Vector3d> axis_of_revolution(std::span<const body::Part> parts);

}  // namespace twrench::render
