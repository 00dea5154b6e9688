#pragma once

#include <twrench/body/mass_properties.h>
#include <twrench/body/shape.h>

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>

namespace twrench::picture {

/// Returns the axis that is reversed when a body turns over, as a unit vector in body axes: the
/// intermediate axis or, if two moments are equal, the axis of symmetry. Returns nothing if all
/// three are equal: then any axis may be reversed.
std::optional<Eigen::Vector3d> reversed_axis(const body::PrincipalAxes& principal);

// Parts that look alike have the same number in `looks`, which has one for each part. Places that
// differ by less than a thousandth of the body's bounding radius, and thus by less than a pixel,
// count as the same. Meshes are compared by their vertices and the colours of these.

/// Returns whether a body looks the same after half a turn about an axis through the origin, given
/// as a unit vector in body axes.
bool looks_the_same_after_half_turn(std::span<const body::Part> parts,
                                    std::span<const std::size_t> looks,
                                    const Eigen::Vector3d& axis);

/// Returns whether a body can look the same after it has turned over: whether half a turn that
/// reverses reversed_axis() maps it to itself.
bool looks_the_same_turned_over(std::span<const body::Part> parts,
                                std::span<const std::size_t> looks,
                                const body::PrincipalAxes& principal);

}  // namespace twrench::picture
