#pragma once

#include <string_view>

#include "table/reader.h"

namespace twrench::table {

/// Reads a calendar time of ISO 8601 with its date, "2026-03-04T10:11:05.020" or with the day of
/// the year, "2026-063T10:11:05", and perhaps a "Z" at the end, as seconds since 1970 without leap
/// seconds. The number has the decimals of the text. Returns false for any other text.
bool read_calendar_time(std::string_view text, Number& number);

}  // namespace twrench::table
