#pragma once

#include <string>
#include <string_view>

namespace twrench::app {

/// Returns the text as XML or HTML content, or as an attribute's value in quotation marks: as
/// escape() shows it, with character references. What XML 1.0 does not allow is not in it.
std::string xml_text(std::string_view text);

}  // namespace twrench::app
