#pragma once

#include <twrench/body/shape.h>

#include <Eigen/Core>
#include <array>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <vector>

namespace twrench::picture {

/// Returns the axis of a body of revolution, which passes through the origin, as a unit vector in
/// body axes; for a sphere, its own z axis. Returns nothing for other bodies.
std::optional<Eigen::Vector3d> axis_of_revolution(std::span<const body::Part> parts);

/// The rows of the matrix that maps (position, 1) in body axes, cm, to the position across an axis.
using AcrossFromBody = std::array<glm::vec4, 2>;

/// Returns for each part the position across an axis. For a body of revolution, this is the common
/// axis of all parts, in units of the body's largest radius about it. Otherwise it is the
/// own axis of each shape of revolution, in units of the shape's radius; 0 for other shapes.
std::vector<AcrossFromBody> across_from_body(std::span<const body::Part> parts);

}  // namespace twrench::picture
