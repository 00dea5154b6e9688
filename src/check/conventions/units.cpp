#include "check/conventions/units.h"

#include <algorithm>
#include <numbers>

namespace twrench::check {

const std::vector<RateUnitName>& rate_units() {
  static const std::vector<RateUnitName> units{
      {RateUnit::rad_s, "rad", "rad/s", 1},
      {RateUnit::deg_s, "deg", "deg/s", std::numbers::pi / 180},
      {RateUnit::rev_s, "rev", "rev/s", 2 * std::numbers::pi},
      {RateUnit::rpm, "rpm", "rpm", 2 * std::numbers::pi / 60}};
  return units;
}

const RateUnitName& name_of(RateUnit unit) {
  return *std::ranges::find(rate_units(), unit, &RateUnitName::unit);
}

const std::vector<AngleName>& angle_units() {
  static const std::vector<AngleName> units{{Angle::radians, "rad", 1},
                                            {Angle::degrees, "deg", std::numbers::pi / 180}};
  return units;
}

const AngleName& name_of(Angle unit) {
  return *std::ranges::find(angle_units(), unit, &AngleName::unit);
}

const std::vector<TimeUnitName>& time_units() {
  static const std::vector<TimeUnitName> units{
      {TimeUnit::s, "s", 1},      {TimeUnit::ms, "ms", 1e-3}, {TimeUnit::us, "us", 1e-6},
      {TimeUnit::ns, "ns", 1e-9}, {TimeUnit::min, "min", 60}, {TimeUnit::h, "h", 3600}};
  return units;
}

const TimeUnitName& name_of(TimeUnit unit) {
  return *std::ranges::find(time_units(), unit, &TimeUnitName::unit);
}

std::optional<Angle> angle_of(RateUnit unit) {
  switch (unit) {
    case RateUnit::rad_s:
      return Angle::radians;
    case RateUnit::deg_s:
      return Angle::degrees;
    case RateUnit::rev_s:
    case RateUnit::rpm:
      return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace twrench::check
