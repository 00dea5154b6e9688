#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "check/conventions/convention.h"

namespace twrench::check {

/// How options and people name a unit of rates, and how large it is.
struct RateUnitName {
  RateUnit unit;
  const char* option;  ///< "deg"
  const char* symbol;  ///< "deg/s"
  double in_rad_s;     ///< how many rad/s one of it has
};
std::span<const RateUnitName> rate_units();
const RateUnitName& name_of(RateUnit unit);

/// The same of angles.
struct AngleName {
  Angle unit;
  const char* option;  ///< "deg"
  double in_rad;
};
std::span<const AngleName> angle_units();
const AngleName& name_of(Angle unit);

/// The same of times.
struct TimeUnitName {
  TimeUnit unit;
  const char* option;  ///< "ms"
  double in_s;
};
std::span<const TimeUnitName> time_units();
const TimeUnitName& name_of(TimeUnit unit);

/// The unit of angles that a rate has in each second; nothing for revolutions, in which nobody
/// writes Euler angles.
std::optional<Angle> angle_of(RateUnit unit);

}  // namespace twrench::check
