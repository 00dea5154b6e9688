#pragma once

#include <string>

#include "check/conventions/convention.h"

namespace twrench::app {

/// Returns the options to add where the first convention is in force, so that the second is:
/// "--units deg --inverse".
std::string option_text(const check::Convention& before, const check::Convention& after);

/// Returns whether both conventions have the same offset, as far as a file can tell it.
bool is_same_offset(const check::Convention& before, const check::Convention& after);

}  // namespace twrench::app
