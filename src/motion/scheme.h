#pragma once

#include <twrench/motion/method.h>

#include <array>
#include <cstddef>
#include <variant>

namespace twrench::motion {

/// Coefficients of the stages, starting with the first.
using TableauRow = std::array<double, 6>;

/// An explicit Runge-Kutta tableau of at most six stages.
struct Tableau {
  int stages;                   ///< Number of stages in use.
  int order;                    ///< p, in a linear space, of the solution that is advanced
  std::array<TableauRow, 6> a;  ///< TableauRow k holds a_k1 to a_k(k-1).
  TableauRow weights;           ///< Weights of the solution that is advanced.
  TableauRow embedded{};        ///< Weights of the other solution, for the error estimate.
  bool embedded_pair = false;   ///< Whether there are embedded weights and thus an error estimate.
};

/// How a Runge-Kutta step maps the stage velocities to the group.
enum class Update {
  /// W' = W + h W Omega in the space of matrices, eq. (24); leaves SO(3).
  linear,
  /// W' = W exp(h sum b_k S_k) without commutators, sections 4.1 to 4.5.
  averaged,
  /// As `averaged`, but with dexpinv of the stage velocities, which restores the tableau's order.
  munthe_kaas,
};

/// A Runge-Kutta method on the group.
struct RungeKutta {
  /// How the step reaches the group.
  Update update;
  /// Its coefficients.
  Tableau tableau;
};

/// Stages that are products of exponentials of linear combinations of the stage velocities, without
/// commutators. TableauRow 0 of each product acts first.
struct CommutatorFree {
  /// Exponents of two factors.
  using Product = std::array<TableauRow, 2>;
  /// Number of stages in use.
  int stages;
  /// Exponents of each stage.
  std::array<Product, 4> stage;
  /// Exponents of the step.
  Product update;
};

/// The implicit trapezoidal rule W' = W exp(h w), where w is the velocity of the mean of the body
/// momenta at both ends, applied successively to each of the given fractions of the step.
struct ImplicitTrapezoid {
  /// Number of fractions in use.
  int count;
  /// Fractions of the step, which sum to 1.
  std::array<double, 5> fractions;
};

/// A splitting of the energy into its terms m_i^2/(2 I_i) along the principal axes, whose flows are
/// rotations about the axes: half a step of the first two, a step of the third, and the halves in
/// reverse order.
struct StrangSplitting {};

/// The highest order that a Taylor series may have.
inline constexpr std::size_t max_taylor_order = 30;

/// The Taylor series of the motion, motion/taylor.h. Its last terms determine the step size.
struct Taylor {
  /// Highest order of the series.
  int order;
};

/// The exact solution, motion/exact.h. Its steps may have any size.
struct ClosedForm {};

/// The algorithm that takes a method from one time to another.
struct Scheme {
  std::variant<RungeKutta, CommutatorFree, ImplicitTrapezoid, StrangSplitting, Taylor, ClosedForm>
      kind;
};

}  // namespace twrench::motion
