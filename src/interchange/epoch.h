#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace twrench::interchange {

/// A date and time of day, in whole seconds of whatever time system: every day has 86,400 of them.
using Epoch = std::chrono::sys_seconds;

/// Returns the epoch of a text "YYYY-MM-DDThh:mm:ss". Throws InvalidArgument about `what`.
Epoch parse_epoch(const std::string& text, const std::string& what);

/// Returns the instant so many nanoseconds, >= 0, after the epoch as
/// "YYYY-MM-DDThh:mm:ss.nnnnnnnnn". Throws InvalidArgument about "epoch" if it is after the year
/// 9999.
std::string format_epoch(Epoch epoch, std::int64_t nanoseconds);

}  // namespace twrench::interchange
