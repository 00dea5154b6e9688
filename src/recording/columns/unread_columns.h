#pragma once

#include <string>
#include <vector>

#include "recording/conventions/convention.h"
#include "table/reader.h"

namespace twrench::recording {

/// The columns that the convention does not use, but that could be an attitude: three or more whose
/// names differ only in the component, and name no other quantity. Empty if the convention has an
/// attitude.
std::vector<std::string> possible_attitude_columns(const table::Header& header,
                                                   const Convention& convention);

}  // namespace twrench::recording
