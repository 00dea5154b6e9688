
#include <algorithm>
#include <array>

#include "base/words.h"
#include "motion/scheme.h"

namespace twrench::motion {
namespace {

constexpr Tableau one_stage{.stages = 1, .order = 1, .a = {}, .weights = {1.0}};

constexpr Tableau explicit_midpoint{
    .stages = 2, .order = 2, .a = {{{}, {1.0 / 2}}}, .weights = {0.0, 1.0}};

constexpr Tableau explicit_trapezoid{
    .stages = 2, .order = 2, .a = {{{}, {1.0}}}, .weights = {1.0 / 2, 1.0 / 2}};

constexpr Tableau kutta{.stages = 4,
                        .order = 4,
                        .a = {{{}, {1.0 / 2}, {0.0, 1.0 / 2}, {0.0, 0.0, 1.0}}},
                        .weights = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6}};

/// Fehlberg's pair, eq. (39). The 4th-order row advances the solution; the error estimate compares
/// it with the 5th-order row.
constexpr Tableau fehlberg{
    .stages = 6,
    .order = 4,
    .a = {{{},
           {1.0 / 4},
           {3.0 / 32, 9.0 / 32},
           {1932.0 / 2197, -7200.0 / 2197, 7296.0 / 2197},
           {439.0 / 216, -8.0, 3680.0 / 513, -845.0 / 4104},
           {-8.0 / 27, 2.0, -3544.0 / 2565, 1859.0 / 4104, -11.0 / 40}}},
    .weights = {25.0 / 216, 0.0, 1408.0 / 2565, 2197.0 / 4104, -1.0 / 5, 0.0},
    .embedded = {16.0 / 135, 0.0, 6656.0 / 12825, 28561.0 / 56430, -9.0 / 50, 2.0 / 55},
    .embedded_pair = true};

/// Celledoni, Marthinsen and Owren: X2 = X e^(k1/2), X3 = X e^(k2/2), X4 = X2 e^(k3 - k1/2).
constexpr CommutatorFree two_exponentials{
    .stages = 4,
    .stage = {{{}, {{{1.0 / 2}, {}}}, {{{0.0, 1.0 / 2}, {}}}, {{{1.0 / 2}, {-1.0 / 2, 0.0, 1.0}}}}},
    .update = {
        {{3.0 / 12, 2.0 / 12, 2.0 / 12, -1.0 / 12}, {-1.0 / 12, 2.0 / 12, 2.0 / 12, 3.0 / 12}}}};

/// Suzuki's fractal composition: four steps of p and one of 1 - 4p, backwards, cancel the h^3
/// error.
constexpr double suzuki = 0.41449077179437573714;  // 1/(4 - 4^(1/3))
constexpr ImplicitTrapezoid suzuki_trapezoid{
    .count = 5, .fractions = {suzuki, suzuki, 1.0 - 4.0 * suzuki, suzuki, suzuki}};

namespace schemes {

constexpr Scheme euler{RungeKutta{Update::linear, one_stage}};
constexpr Scheme lie_euler{RungeKutta{Update::averaged, one_stage}};
constexpr Scheme midpoint{RungeKutta{Update::averaged, explicit_midpoint}};
constexpr Scheme trapezoid{RungeKutta{Update::averaged, explicit_trapezoid}};
constexpr Scheme rk4{RungeKutta{Update::averaged, kutta}};
constexpr Scheme rkf45{RungeKutta{Update::averaged, fehlberg}};
constexpr Scheme implicit_trapezoid{ImplicitTrapezoid{1, {1.0}}};
constexpr Scheme strang{StrangSplitting{}};
constexpr Scheme rkmk4{RungeKutta{Update::munthe_kaas, kutta}};
constexpr Scheme rkmk45{RungeKutta{Update::munthe_kaas, fehlberg}};
constexpr Scheme cf4{two_exponentials};
constexpr Scheme suzuki4{suzuki_trapezoid};
constexpr Scheme taylor{Taylor{20}};
constexpr Scheme exact{ClosedForm{}};

}  // namespace schemes

// The specification is H. J. Rivertz, "Rotasjon av stive legemer" (2020). `rk4` and `rkf45` measure
// order 2 on SO(3), not 4 and 5: a single exponential of the averaged stage velocities omits their
// commutators, to leading order (h^3/12) omega x omega'.
constexpr auto all = std::to_array<Method>({
    {"euler", &schemes::euler, 1, false, false, "specification, eq. (24)",
     "Euler's method on the matrix itself; drifts off SO(3); for comparison"},
    {"lie-euler", &schemes::lie_euler, 1, false, false, "specification, eq. (25)",
     "Lie-Euler method on the group: one exponential per step"},
    {"midpoint", &schemes::midpoint, 2, false, false, "specification, 4.2",
     "explicit midpoint rule on the group"},
    {"trapezoid", &schemes::trapezoid, 2, false, false, "specification, 4.3",
     "explicit trapezoid rule on the group"},
    {"rk4", &schemes::rk4, 2, false, false, "specification, 4.4",
     "RK4 as the specification prints it: no commutators, hence order 2 on SO(3)"},
    {"rkf45", &schemes::rkf45, 2, false, false, "specification, 4.5, eq. (39)",
     "Runge-Kutta-Fehlberg as printed, adaptive: no commutators, hence order 2 on SO(3)"},
    {"implicit-trapezoid", &schemes::implicit_trapezoid, 2, true, true,
     "Simo, Wong, Int. J. Numer. Methods Eng. 31 (1991)",
     "symmetric; conserves energy to round-off"},
    {"strang", &schemes::strang, 2, false, true, "McLachlan, Phys. Rev. Lett. 71 (1993)",
     "splitting into rotations about the principal axes; Poisson, bounded energy error"},
    {"rkmk4", &schemes::rkmk4, 4, false, false, "Munthe-Kaas, Appl. Numer. Math. 29 (1999)",
     "the specification's RK4 with commutator correction"},
    {"rkmk45", &schemes::rkmk45, 4, false, false, "Munthe-Kaas, Appl. Numer. Math. 29 (1999)",
     "the specification's RKF45 with commutator correction, adaptive; the default"},
    {"cf4", &schemes::cf4, 4, false, false,
     "Celledoni, Marthinsen, Owren, Future Gener. Comput. Syst. 19 (2003)",
     "commutator-free: products of two exponentials"},
    {"suzuki4", &schemes::suzuki4, 4, true, true, "Suzuki, Phys. Lett. A 146 (1990)",
     "five implicit trapezoidal steps per step; conserves energy to round-off"},
    {"taylor", &schemes::taylor, 20, true, false,
     "Jorba, Zou, Exp. Math. 14 (2005); docs/performance.md",
     "Taylor series of momentum and one angle, adaptive; conserves energy; the fastest"},
    {"exact", &schemes::exact, std::nullopt, true, true,
     "Jacobi, J. reine angew. Math. 39 (1849); docs/exact.md",
     "closed form with elliptic and theta functions; the same cost at any t"},
});

}  // namespace

bool Method::exact() const { return std::holds_alternative<ClosedForm>(scheme->kind); }

bool Method::adaptive() const {
  const auto* rk = std::get_if<RungeKutta>(&scheme->kind);
  return std::holds_alternative<Taylor>(scheme->kind) ||
         (rk != nullptr && rk->tableau.embedded_pair);
}

bool Method::linear() const {
  const auto* rk = std::get_if<RungeKutta>(&scheme->kind);
  return rk != nullptr && rk->update == Update::linear;
}

std::span<const Method> methods() { return all; }

std::vector<std::string> method_names() {
  std::vector<std::string> names;
  for (const Method& m : all) names.emplace_back(m.name);
  return names;
}

const Method& find_method(std::string_view name, std::string_view what) {
  const auto found = std::ranges::find(all, name, &Method::name);
  if (found == all.end()) throw unknown_name(std::string(what), name, method_names());
  return *found;
}

}  // namespace twrench::motion
