#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace twrench::interchange {

/// A date and time of day in whole seconds. The time system is arbitrary, but every day has 86,400
/// seconds.
using Epoch = std::chrono::sys_seconds;

/// Returns the epoch of a text "YYYY-MM-DDThh:mm:ss". Throws InvalidArgument about `what`.
Epoch parse_epoch(const std::string& text, const std::string& what);

/// Returns the instant `ticks`, >= 0, after the epoch as "YYYY-MM-DDThh:mm:ss.fff". A tick is
/// 10^-digits s, and the fraction has `digits` digits, 1 to 18. Throws InvalidArgument about
/// "epoch" if the instant is after the year 9999.
std::string format_epoch(Epoch epoch, std::int64_t ticks, int digits);

}  // namespace twrench::interchange
