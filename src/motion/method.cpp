#include "motion/method.h"

#include <algorithm>

#include "base/nearest.h"

namespace twrench {
namespace {

constexpr Tableau one_stage{.stages = 1, .a = {}, .weights = {1.0}};

constexpr Tableau explicit_midpoint{
    .stages = 2, .a = {{{}, {1.0 / 2}}}, .weights = {0.0, 1.0}};

constexpr Tableau explicit_trapezoid{
    .stages = 2, .a = {{{}, {1.0}}}, .weights = {1.0 / 2, 1.0 / 2}};

constexpr Tableau kutta{.stages = 4,
                        .a = {{{}, {1.0 / 2}, {0.0, 1.0 / 2}, {0.0, 0.0, 1.0}}},
                        .weights = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6}};

/// Fehlberg's pair, eq. (39). The 4th-order row is carried on; the 5th-order row is held against it.
constexpr Tableau fehlberg{
    .stages = 6,
    .a = {{{},
           {1.0 / 4},
           {3.0 / 32, 9.0 / 32},
           {1932.0 / 2197, -7200.0 / 2197, 7296.0 / 2197},
           {439.0 / 216, -8.0, 3680.0 / 513, -845.0 / 4104},
           {-8.0 / 27, 2.0, -3544.0 / 2565, 1859.0 / 4104, -11.0 / 40}}},
    .weights = {25.0 / 216, 0.0, 1408.0 / 2565, 2197.0 / 4104, -1.0 / 5, 0.0},
    .embedded = {16.0 / 135, 0.0, 6656.0 / 12825, 28561.0 / 56430, -9.0 / 50, 2.0 / 55},
    .embedded_pair = true};

// The specification is H. J. Rivertz, "Rotasjon av stive legemer" (2020). `rk4` and `rkf45` measure
// order 2 on SO(3), not 4 and 5: one exponential of the averaged stage velocities drops their
// commutators, first of all (h^3/12) omega x omega'.
constexpr Method all[] = {
    {"euler", Update::linear, one_stage, 1, 1, "eq. (24)",
     "Euler's method on the matrix itself; leaves SO(3), for comparison"},
    {"lie-euler", Update::exponential, one_stage, 1, 1, "eq. (25)",
     "Euler's method on the group: one exponential a step"},
    {"midpoint", Update::exponential, explicit_midpoint, 2, 2, "section 4.2",
     "explicit midpoint rule on the group"},
    {"trapezoid", Update::exponential, explicit_trapezoid, 2, 2, "section 4.3",
     "explicit trapezoid rule on the group"},
    {"rk4", Update::exponential, kutta, 2, 4, "section 4.4",
     "Runge-Kutta 4 as the specification prints it: no commutators, so order 2 on SO(3)"},
    {"rkf45", Update::exponential, fehlberg, 2, 4, "section 4.5, eq. (39)",
     "Runge-Kutta-Fehlberg as printed, adaptive: no commutators, so order 2 on SO(3)"},
};

}  // namespace

std::span<const Method> methods() { return all; }

std::vector<std::string> method_names() {
  std::vector<std::string> names;
  for (const Method& m : all) names.emplace_back(m.name);
  return names;
}

const Method& find_method(std::string_view name, const std::string& what) {
  const auto found = std::ranges::find(all, name, &Method::name);
  if (found == std::end(all)) throw unknown_name(what, name, method_names());
  return *found;
}

}  // namespace twrench
