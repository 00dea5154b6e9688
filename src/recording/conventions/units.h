#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "recording/conventions/convention.h"

namespace twrench::recording {

/// A unit of rates: its names in options and texts, and its size.
struct RateUnitName {
  RateUnit unit;
  const char* option;  ///< "deg"
  const char* symbol;  ///< "deg/s"
  double in_rad_s;     ///< its size
};
std::span<const RateUnitName> units_of_rates();
const RateUnitName& name_of(RateUnit unit);

/// The same for angles.
struct AngleName {
  Angle unit;
  const char* option;  ///< "deg"
  double in_rad;
};
std::span<const AngleName> units_of_angles();
const AngleName& name_of(Angle unit);

/// The same for times.
struct TimeUnitName {
  TimeUnit unit;
  const char* option;  ///< "ms"
  double in_s;
};
std::span<const TimeUnitName> units_of_times();
/// All but days, which the names of columns state, and 0.1 ms, which only the clocks of a few
/// sensors count.
std::span<const TimeUnitName> common_units_of_times();
const TimeUnitName& name_of(TimeUnit unit);

/// The unit of angles of a rate: degrees for deg/s. Nothing for revolutions, which are not used for
/// Euler angles.
std::optional<Angle> angle_of(RateUnit unit);

}  // namespace twrench::recording
