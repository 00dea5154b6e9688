#pragma once

#include <cstddef>

#include "comparison/comparison.h"

namespace twrench::comparison {

/// Accepts the actual frames: copies those that are different, have another format or are extra
/// over the expected ones, each atomically, and returns their number. Frames that are alike or
/// missing remain unchanged. Copies nothing if a frame could not be read. Throws FileError, also if
/// another run writes to the folder.
std::size_t update_expected(const Comparison& comparison);

}  // namespace twrench::comparison
