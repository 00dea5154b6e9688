#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace twrench {

using Row = std::array<double, 6>;

/// An explicit Runge-Kutta tableau of at most six stages.
struct Tableau {
  int stages;
  int order;             ///< in a linear space, of what is carried on; p in the step control
  std::array<Row, 6> a;  ///< row k holds a_k1 .. a_k(k-1)
  Row weights;           ///< of the value that is carried on
  Row embedded{};        ///< of the value held against it for the error estimate
  bool embedded_pair = false;
};

/// How a Runge-Kutta step goes from the stage velocities to the group.
enum class Update {
  linear,       ///< W' = W + h W Omega: in the space of matrices, eq. (24); leaves SO(3)
  averaged,     ///< W' = W exp(h sum b_k S_k): no commutators, sections 4.1 to 4.5
  munthe_kaas,  ///< the same with dexpinv of the stage velocities: the tableau's own order
};

struct RungeKutta {
  Update update;
  Tableau tableau;
};

/// Stages that are products of exponentials of combinations of the stage velocities: no
/// commutators needed. Row 0 of each product acts first.
struct CommutatorFree {
  using Product = std::array<Row, 2>;
  int stages;
  std::array<Product, 4> stage;
  Product update;
};

/// W' = W exp(h w), with w the velocity of the mean of the body momenta at both ends, taken for
/// each of the fractions of the step in turn.
struct ImplicitTrapezoid {
  int count;
  std::array<double, 5> fractions;
};

/// The energy is a sum over the principal axes of m_i^2/(2 I_i); the flow of each term is a
/// rotation about its axis: half of the first two, the third, and back.
struct StrangSplitting {};

inline constexpr std::size_t largest_taylor_order = 30;

/// The Taylor series of the motion, motion/taylor.h: its last terms say how far it holds.
struct Taylor {
  int order;
};

/// The solution itself, motion/exact.h; a step of it, where one is asked for, has any length.
struct ClosedForm {};

using Scheme = std::variant<RungeKutta, CommutatorFree, ImplicitTrapezoid, StrangSplitting, Taylor,
                            ClosedForm>;

/// A method of integration: data, with its citation. One stepper runs them all.
struct Method {
  std::string_view name;
  Scheme scheme;
  std::optional<int> order;  ///< observed on SO(3), which may be less than the tableau's own; none
                             ///< for the closed form, whose error knows no step
  bool conserves_energy;     ///< to round-off, whatever the step (`taylor`: to a tolerance of 1e-8)
  bool reversible;           ///< a step of -h undoes a step of h, to round-off
  std::string_view source;   ///< where the specification or the literature prints it
  std::string_view summary;  ///< one line for people

  /// It is the solution itself, without steps.
  bool exact() const;
  /// It chooses its own steps.
  bool adaptive() const;
  /// It leaves SO(3).
  bool linear() const;
};

/// All methods: the specification's in its order, then the others by order.
std::span<const Method> methods();

std::vector<std::string> method_names();

/// The method called `name`. Throws UsageError about `what`, with the nearest name offered.
const Method& find_method(std::string_view name, std::string_view what = "method");

}  // namespace twrench
