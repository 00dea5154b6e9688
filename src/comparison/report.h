#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "comparison/comparison.h"

namespace twrench::comparison {

/// Where a report goes, piece by piece.
using Write = std::function<void(std::string_view)>;

/// "max 30 mean 0.100000 of 255, 0.010000 of the pixels over 0": what a frame differs by.
std::string difference_text(const FrameResult& frame, const Criteria& criteria);

/// Writes a line for two files; for folders one for each frame that is not what was expected, and
/// one that sums up.
void write_text(const Comparison& comparison, const Write& write);

/// Writes one object, with all frames.
void write_json(const Comparison& comparison, const Write& write);

/// Writes JUnit's XML, as servers for continuous integration read it: a test case for each frame.
void write_junit(const Comparison& comparison, const Write& write);

}  // namespace twrench::comparison
