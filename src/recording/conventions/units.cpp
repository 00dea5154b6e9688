#include "recording/conventions/units.h"

#include <algorithm>
#include <array>
#include <numbers>

#include "base/enumeration.h"

namespace twrench::recording {
namespace {

constexpr std::array rate_unit_names{
    RateUnitName{RateUnit::rad_s, "rad", "rad/s", 1},
    RateUnitName{RateUnit::deg_s, "deg", "deg/s", std::numbers::pi / 180},
    RateUnitName{RateUnit::rev_s, "rev", "rev/s", 2 * std::numbers::pi},
    RateUnitName{RateUnit::rpm, "rpm", "rpm", 2 * std::numbers::pi / 60}};
static_assert(has_row_for_each(rate_unit_names, &RateUnitName::unit));

constexpr std::array angle_names{AngleName{Angle::radians, "rad", 1},
                                 AngleName{Angle::degrees, "deg", std::numbers::pi / 180}};
static_assert(has_row_for_each(angle_names, &AngleName::unit));

constexpr std::array time_unit_names{
    TimeUnitName{TimeUnit::s, "s", 1},      TimeUnitName{TimeUnit::ms, "ms", 1e-3},
    TimeUnitName{TimeUnit::us, "us", 1e-6}, TimeUnitName{TimeUnit::ns, "ns", 1e-9},
    TimeUnitName{TimeUnit::min, "min", 60}, TimeUnitName{TimeUnit::h, "h", 3600},
    TimeUnitName{TimeUnit::d, "d", 86400},  TimeUnitName{TimeUnit::tenth_ms, "0.1ms", 1e-4}};
static_assert(has_row_for_each(time_unit_names, &TimeUnitName::unit));

}  // namespace

std::span<const RateUnitName> units_of_rates() { return rate_unit_names; }

const RateUnitName& name_of(RateUnit unit) {
  return *std::ranges::find(rate_unit_names, unit, &RateUnitName::unit);
}

std::span<const AngleName> units_of_angles() { return angle_names; }

const AngleName& name_of(Angle unit) {
  return *std::ranges::find(angle_names, unit, &AngleName::unit);
}

std::span<const TimeUnitName> units_of_times() { return time_unit_names; }

std::span<const TimeUnitName> common_units_of_times() {
  return std::span(time_unit_names).first<time_unit_names.size() - 2>();
}

const TimeUnitName& name_of(TimeUnit unit) {
  return *std::ranges::find(time_unit_names, unit, &TimeUnitName::unit);
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

}  // namespace twrench::recording
