#pragma once

#include <string_view>

#include "table/input.h"

namespace twrench::table {

/// Whether the text begins with the byte order mark of UTF-16.
bool has_utf16_mark(std::string_view start);

/// Converts a text in UTF-16, which begins with its byte order mark, to UTF-8 in memory. Throws
/// system::FileError if it has an invalid character or ends within one.
Input utf8_from_utf16(const Input& input);

}  // namespace twrench::table
