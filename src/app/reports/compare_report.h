#pragma once

#include <string>

#include "app/terminal/output.h"
#include "comparison/comparison.h"

namespace twrench::app {

/// "max 30 mean 0.100000 of 255, 0.010000 of the pixels over 0": what a frame differs by.
std::string difference_text(const comparison::FrameResult& frame,
                            const comparison::Criteria& criteria);

/// Writes a line for two files; for folders one for each frame that is not what was expected, and
/// one that sums up.
void write_compare_text(const comparison::Comparison& comparison, Output& output);

/// Writes one object, with all frames.
void write_compare_json(const comparison::Comparison& comparison, Output& output);

/// Writes JUnit's XML, as servers for continuous integration read it: a test case for each frame.
void write_compare_junit(const comparison::Comparison& comparison, Output& output);

}  // namespace twrench::app
