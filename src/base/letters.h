#pragma once

#include <string>
#include <string_view>

namespace twrench {

/// Returns the text in lower case. Only A to Z are changed.
std::string to_lower(std::string_view text);

}  // namespace twrench
