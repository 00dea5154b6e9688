#pragma once

#include <string>
#include <string_view>

#include "table/reader.h"

namespace twrench::table {

/// Reads a calendar time in the form of ISO 8601: 2026-03-04, 2026-03-04T10:11:05.25Z, a blank for
/// the T, slashes for the hyphens, the day of the year (2026-063), an offset (+01:00), or the time
/// of a day alone (10:11:05.25). The number is in s since 1970, or since midnight, with at most
/// nine decimals. A time without an offset counts as UTC. A second 60 is a leap second: its number
/// is that of the following second.
Calendar read_calendar(std::string_view text, Number& number);

/// The inverse, with the decimals of the number; its offset is that of UTC.
std::string calendar_text(Calendar calendar, const Number& number);

/// The number of nanoseconds as a number of seconds with `decimals` digits, up to nine.
Number seconds_from(long long nanoseconds, int decimals);

}  // namespace twrench::table
