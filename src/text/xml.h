#pragma once

#include <string>
#include <string_view>

namespace twrench::text {

/// Returns the text as XML or HTML content, or as an attribute's value in quotation marks: as
/// escape() shows it, with character references. Characters that XML 1.0 does not allow are
/// escaped.
std::string escape_xml(std::string_view text);

}  // namespace twrench::text
