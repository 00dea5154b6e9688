#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "interchange/played_motion.h"

namespace twrench::interchange {

/// The least angle in rad that key_times() can guarantee, because keys are float32 numbers.
inline constexpr double least_max_angle = 1e-6;

/// Returns the times at which an attitude or a direction needs keys, so that the interpolation
/// between them is nowhere further than `max_angle` (rad) from it. The times ascend from 0 to the
/// float32 number nearest to `end`. Their unit is that of the player's clock; errors name it by
/// `unit`. All are exactly float32 numbers: compute each key for the time
/// that is written, so that rounding the time adds no error.
///
/// The bound holds for spherical linear interpolation, as glTF defines LINEAR, and for normalised
/// linear interpolation, which several programs use instead. It includes the rounding of the keys
/// to float32. `bounds` returns the rates between two times.
///
/// Throws OutOfRange about "max_angle" if it is less than least_max_angle, and AccuracyError if the
/// keys would have to be closer to each other than float32 numbers are, or are too many.
std::vector<float> key_times(double end, double max_angle,
                             const std::function<RateBounds(double begin, double end)>& bounds,
                             std::string_view unit = "s");

}  // namespace twrench::interchange
