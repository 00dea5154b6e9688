#pragma once

#include <string>

#include "check/conventions/convention.h"

namespace twrench::check {

/// Returns the options to add to change the first convention into the second:
/// "--units deg --inverse".
std::string option_text(const Convention& before, const Convention& after);

/// Returns whether both conventions have the same offset up to rounding.
bool is_same_offset(const Convention& before, const Convention& after);

}  // namespace twrench::check
