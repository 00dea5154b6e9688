#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace twrench {

/// Returns the text in lower case. Only A to Z are changed.
std::string to_lower(std::string_view text);

/// Returns the words of the text, which white space separates.
std::vector<std::string> words_of(const std::string& text);

}  // namespace twrench
