#pragma once

#include <string_view>

#include "table/input.h"

namespace twrench::table {

/// Whether the text begins like an XML document.
bool is_xml(std::string_view start);

/// Converts the attitude ephemeris messages of an XML document (CCSDS 505.0-B), alone or in an
/// <ndm>, to keywords and values in memory. Throws system::FileError if the document is cut off or
/// larger than 64 MiB, has no such message, or if its values are not those of its ATTITUDE_TYPE.
Input aem_from_xml(const Input& input);

}  // namespace twrench::table
