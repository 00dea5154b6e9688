#pragma once

#include <string>
#include <string_view>

namespace twrench::text {

/// Returns the text on one line and safe for a terminal: control characters, invisible characters
/// that reorder or hide others, and invalid UTF-8 become \n, \x1b, \u202e. The result is for
/// display, not for parsing: backslashes stay as they are.
std::string escape(std::string_view text);

}  // namespace twrench::text
