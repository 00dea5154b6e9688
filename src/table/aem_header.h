#pragma once

#include <string>

#include "table/aem_reader.h"
#include "table/reader.h"

namespace twrench::table {

/// Sets the columns of the segment, their units, and what it states about the attitude, from its
/// metadata. Throws system::FileError for attitudes that are not read.
void describe_aem_columns(const AemSegment& segment, bool is_version_1, Header& header);

}  // namespace twrench::table
