#pragma once

namespace twrench {

/// A unit in which people read times.
struct TimeUnit {
  double length;       ///< In s.
  const char* symbol;  ///< Behind a number: "s", "d".
  const char* name;    ///< On an axis: as the symbol, but "days".
};

/// Returns the unit in which times up to `longest`, in s, read well: seconds from 0.1 s to 10 min.
TimeUnit time_unit(double longest);

}  // namespace twrench
