#pragma once

#include <string>
#include <string_view>

namespace twrench::text {

/// Escapes a text for XML or HTML content, or for an attribute's value in quotation marks: as
/// escape() does, and with character references. Characters that XML 1.0 does not allow are escaped
/// too.
std::string escape_xml(std::string_view text);

}  // namespace twrench::text
