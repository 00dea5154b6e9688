#pragma once

#include <string>
#include <string_view>

#include "table/reader.h"

namespace twrench::table {

/// Whether dates of the form 03/04/2026 begin with the day or the month.
enum class DateOrder { open, day_first, month_first };

/// The order that the date at the beginning of the text has: it has a number beyond 12, points
/// (28.11.2026), or the name of its month. Open for all other texts.
DateOrder stated_order(std::string_view text);

/// Reads a calendar time in the form of ISO 8601: 2026-03-04, 2026-03-04T10:11:05.25Z, a blank for
/// the T, slashes for the hyphens, the day of the year (2026-063), an offset (+01:00), no
/// separators (20260304T101105), or the time of a day alone (10:11:05.25). Dates of the forms
/// 28/11/2026, 11/28/2026, 28.11.2026 and 28 Nov 2026 are read as well, if the order is given or
/// stated, and times with AM or PM. The number is in s since 1970, or since midnight, with at most
/// nine decimals. A time without an offset counts as UTC. A second 60 is a leap second: its number
/// is that of the following second.
Calendar read_calendar(std::string_view text, Number& number, DateOrder order = DateOrder::open);

/// The inverse, with the decimals of the number; its offset is that of UTC.
std::string calendar_text(Calendar calendar, const Number& number);

/// The number of nanoseconds as a number of seconds with `decimals` digits, up to nine.
Number seconds_from(long long nanoseconds, int decimals);

}  // namespace twrench::table
