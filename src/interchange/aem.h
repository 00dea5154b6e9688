#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "interchange/epoch.h"
#include "scene/scene.h"

namespace twrench::interchange {

/// Writes the exact motion of a scene as a CCSDS attitude ephemeris message in key-value notation,
/// version 1.0 (CCSDS 504.0-B-1), in pieces. The rows show it at time(0), ..., time(count - 1), in
/// s after the epoch and ascending, to the nanosecond, or to a thousandth of the mean interval if
/// that is finer. `generator` is the program's name and version.
///
/// A row has the unit quaternion of X, space_from_body, with the scalar last. It turns the axes of
/// the space frame, REF_FRAME_A, into those of the body, REF_FRAME_B (A2B). Consecutive quaternions
/// have a positive dot product.
///
/// Throws InvalidArgument about "epoch" if the motion lasts beyond the year 9999.
void write_aem(const scene::Scene& scene, Epoch epoch, const std::string& generator,
               std::size_t count, const std::function<double(std::size_t)>& time,
               const std::function<void(std::string_view)>& write);

}  // namespace twrench::interchange
