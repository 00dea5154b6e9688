#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "table/error.h"
#include "table/reader.h"

namespace twrench::recording {

/// Returns the table with a further column for each time that follows from other columns: whole
/// seconds and their nanoseconds or microseconds, a date and the time of the day, a week and its
/// seconds, year to second, or the number of a frame, or of the row in a file without times, and
/// the rate that a line before the names states. The new column is named "header.stamp.sec +
/// header.stamp.nanosec" or "frame / 50 Hz" and loses no digits. Its rows throw table::BadTable
/// unless the parts are whole numbers within their limits. Counters that begin again after their
/// largest number, such as Xsens' PacketCounter, are continued.
std::unique_ptr<table::Reader> with_derived_times(std::unique_ptr<table::Reader> table);

/// The error for rows that are numbered by `numbers` without a stated rate.
table::BadTable unknown_rate(const table::Header& header, const std::string& numbers);

/// The column that counts the rows by its name: "Frame#", "PacketCounter".
std::optional<std::size_t> frame_column(const table::Header& header);

}  // namespace twrench::recording
