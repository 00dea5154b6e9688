#include "base/time_unit.h"

#include <algorithm>
#include <array>

namespace twrench {

std::span<const TimeUnit> time_units() {
  constexpr double minute = 60, hour = 3600, day = 86400;
  static constexpr std::array<TimeUnit, 8> units{{{day, day, "d", "days"},
                                                  {3 * hour, hour, "h", "h"},
                                                  {10 * minute, minute, "min", "min"},
                                                  {0.1, 1, "s", "s"},
                                                  {1e-4, 1e-3, "ms", "ms"},
                                                  {1e-7, 1e-6, "µs", "µs"},
                                                  {1e-10, 1e-9, "ns", "ns"},
                                                  {0, 1e-12, "ps", "ps"}}};
  return units;
}

TimeUnit time_unit(double longest) {
  const std::span<const TimeUnit> units = time_units();
  const auto found = std::ranges::find_if(
      units.first(units.size() - 1), [&](const TimeUnit& unit) { return longest >= unit.from; });
  return *found;
}

}  // namespace twrench
