#pragma once

#include <string_view>

#include "table/input.h"

namespace twrench::table {

/// Whether the text begins like a log of ArduPilot in which each line is a message of another kind.
bool is_of_ardupilot(std::string_view start);

/// Converts such a log to a table in memory that has the same lines: those of the attitude (ATT)
/// or, if there are none, of the first gyroscope (IMU, GYR); all others are comments. Throws
/// system::FileError if it has neither.
Input table_of_ardupilot(const Input& input);

}  // namespace twrench::table
