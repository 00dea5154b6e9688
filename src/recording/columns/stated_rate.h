#pragma once

#include <optional>
#include <string_view>

#include "table/reader.h"

namespace twrench::recording {

/// The rows a second that the lines before the names state, if they state one: "Frame rate: 100",
/// "# fps: 120", "DataRate=100.000000", "Frame Time: 0.01". If they state several, that of the
/// exported rows counts.
std::optional<double> stated_rate(const table::Header& header);

}  // namespace twrench::recording
