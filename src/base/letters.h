#pragma once

#include <string>
#include <string_view>

namespace twrench {

/// Returns the text in small letters; other characters than those of English stay.
std::string in_small_letters(std::string_view text);

}  // namespace twrench
