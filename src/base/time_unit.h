#pragma once

#include <span>

namespace twrench {

/// A unit in which people read times.
struct TimeUnit {
  double from;         ///< The shortest time in s that is written in the unit.
  double length;       ///< Length in s.
  const char* symbol;  ///< After a number: "s", "d".
  const char* name;    ///< On an axis: the symbol, except that days are "days".
};

/// Returns all units, the longest first.
std::span<const TimeUnit> time_units();

/// Returns the unit in which times up to `longest`, in s, are easy to read: seconds from 0.1 s to
/// 10 min.
TimeUnit time_unit(double longest);

}  // namespace twrench
