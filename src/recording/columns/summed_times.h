#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <utility>

#include "table/reader.h"

namespace twrench::recording {

/// Returns the table with a further column for each time that it writes in two: whole seconds and
/// their nanoseconds or microseconds, or a date and the time of the day. The new column is named
/// "header.stamp.sec + header.stamp.nanosec" and loses no digits. Its rows throw table::BadTable
/// unless the parts are whole numbers and the second one is less than a second.
std::unique_ptr<table::Reader> with_summed_times(std::unique_ptr<table::Reader> table);

/// The columns whose sum this column is, if it is one.
std::optional<std::pair<std::size_t, std::size_t>> terms_of(const table::Header& header,
                                                            std::size_t column);

}  // namespace twrench::recording
