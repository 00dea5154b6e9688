#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace twrench {

/// A character of UTF-8: its code point, and how many bytes it takes.
struct Utf8Character {
  char32_t point;
  std::size_t length;
};

/// The first of a text that is not empty; a byte that is not part of well-formed UTF-8 (Unicode 15,
/// table 3-7) counts as U+FFFD of one byte.
Utf8Character first_character(std::string_view text);

/// The code points of the text; U+FFFD stands for each byte that is not part of well-formed
/// UTF-8, and a space for each control character.
std::vector<char32_t> decode_utf8(std::string_view text);

}  // namespace twrench
