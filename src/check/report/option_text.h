#pragma once

#include <string>

#include "recording/conventions/convention.h"

namespace twrench::check {

/// Returns the options to add to change the first convention into the second:
/// "--units deg --inverse".
std::string option_text(const recording::Convention& before, const recording::Convention& after);

/// Returns whether both conventions have the same offset up to rounding.
bool is_same_offset(const recording::Convention& before, const recording::Convention& after);

}  // namespace twrench::check
