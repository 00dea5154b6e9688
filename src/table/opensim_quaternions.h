#pragma once

#include <string_view>

#include "table/input.h"

namespace twrench::table {

/// Whether the text begins like a file of OpenSim whose cells are quaternions.
bool has_quaternion_cells(std::string_view start);

/// Converts the file to a table in memory that has the same lines, but a column for each component:
/// "pelvis_imu.qw", "pelvis_imu.qx" ...
Input table_of_quaternions(const Input& input);

}  // namespace twrench::table
