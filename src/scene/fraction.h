#pragma once

#include <string>

namespace twrench::scene {

/// Returns the value of a fraction of two whole numbers from 1 to 1000000, such as "30000/1001".
/// Throws InvalidArgument about `what` for another text.
double parse_fraction(const std::string& text, const std::string& what);

}  // namespace twrench::scene
