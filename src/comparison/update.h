#pragma once

#include <cstddef>

#include "comparison/comparison.h"

namespace twrench::comparison {

/// Accepts the actual frames: copies those that are different, of another format or extra to where
/// the expected ones are, each atomically, and returns how many. What is alike stays as it is, and
/// so does what is missing. Copies nothing if a frame could not be read. Throws FileError, also if
/// another run writes to the folder.
std::size_t update_expected(const Comparison& comparison);

}  // namespace twrench::comparison
