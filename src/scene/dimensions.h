#pragma once

#include <functional>
#include <string>

#include "body/dimensions.h"
#include "scene/limits.h"

namespace twrench::scene {

/// Returns the limits of a dimension.
const limits::Limit& limit_of(const body::Dimension& dimension);

/// Returns the location of the value of a key, for messages.
using PlaceOf = std::function<std::string(const std::string& key)>;

/// Throws OutOfRange unless the dimensions are within their limits and a hole is smaller than the
/// solid around it.
void check_dimensions(body::Shape shape, const PlaceOf& place_of);

}  // namespace twrench::scene
