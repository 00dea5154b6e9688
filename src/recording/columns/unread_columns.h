#pragma once

#include <string>
#include <vector>

#include "recording/conventions/convention.h"
#include "table/reader.h"

namespace twrench::recording {

/// The columns that the convention does not use, but that could be what it lacks, rates or an
/// attitude: three or more whose names differ only in the component, and name no other quantity.
std::vector<std::string> unread_columns(const table::Header& header, const Convention& convention);

}  // namespace twrench::recording
