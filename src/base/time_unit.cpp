#include "base/time_unit.h"

#include <array>

namespace twrench {

TimeUnit time_unit(double longest) {
  struct Choice {
    double from;  ///< The shortest time that is written in the unit, s.
    TimeUnit unit;
  };
  constexpr double minute = 60, hour = 3600, day = 86400;
  static constexpr std::array<Choice, 7> choices{{{day, {day, "d", "days"}},
                                                  {3 * hour, {hour, "h", "h"}},
                                                  {10 * minute, {minute, "min", "min"}},
                                                  {0.1, {1, "s", "s"}},
                                                  {1e-4, {1e-3, "ms", "ms"}},
                                                  {1e-7, {1e-6, "µs", "µs"}},
                                                  {1e-10, {1e-9, "ns", "ns"}}}};
  for (const auto& [from, unit] : choices) {
    if (longest >= from) return unit;
  }
  return {1e-12, "ps", "ps"};
}

}  // namespace twrench
