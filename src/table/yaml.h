#pragma once

#include <string_view>

#include "table/input.h"

namespace twrench::table {

/// Whether the text begins like rows in YAML: documents that lines "---" separate, as ROS echoes
/// messages, or a list.
bool is_yaml(std::string_view start);

/// Converts a file of YAML, of at most 64 MiB, to JSON in memory with a line for each document.
/// Throws system::FileError, with the line, if it is not YAML or refers to other parts of itself.
Input json_from_yaml(const Input& input);

}  // namespace twrench::table
