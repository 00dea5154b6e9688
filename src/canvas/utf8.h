#pragma once

#include <string_view>
#include <vector>

namespace twrench {

/// The code points of the text; U+FFFD stands for each byte that is not part of well-formed UTF-8
/// (Unicode 15, table 3-7), and a space for each control character.
std::vector<char32_t> decode_utf8(std::string_view text);

}  // namespace twrench
