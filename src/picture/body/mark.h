#pragma once

#include <twrench/body/mass_properties.h>
#include <twrench/body/shape.h>

#include <array>
#include <cstddef>
#include <glm/vec4.hpp>
#include <optional>
#include <span>

namespace twrench::picture {

/// The mark of a body, black and white paint that shows how it has turned: the rows of the matrix
/// that maps (position, 1) in body axes, cm, to three values. A place is painted if the third
/// exceeds the absolute value of the second, white if the first is positive and black otherwise. No
/// half turn that maps the body to itself maps the paint to itself.
using MarkFromBody = std::array<glm::vec4, 3>;

/// Paints the end of a body in the direction of its reversed_axis(), half of it white and half of
/// it black.
MarkFromBody painted_end(std::span<const body::Part> parts, const body::PrincipalAxes& principal);

/// Returns the paint of a body whose rotation would not be visible without it; nothing for other
/// bodies. A body of revolution has a stripe through its poles or, if it is long, a painted end, as
/// has any other body that looks the same turned over. Parts that look alike have the same number
/// in `looks`.
std::optional<MarkFromBody> mark_from_body(std::span<const body::Part> parts,
                                           std::span<const std::size_t> looks,
                                           const body::PrincipalAxes& principal);

}  // namespace twrench::picture
