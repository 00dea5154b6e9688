#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace twrench {

/// An explicit Runge-Kutta tableau of at most six stages.
struct Tableau {
  using Row = std::array<double, 6>;

  int stages;
  std::array<Row, 6> a;  ///< row k holds a_k1 .. a_k(k-1)
  Row weights;           ///< of the value that is carried on
  Row embedded{};        ///< of the value held against it for the error estimate
  bool embedded_pair = false;
};

/// How a step is taken from the mean of the stage velocities.
enum class Update {
  linear,       ///< W' = W + h W Omega: in the space of matrices, eq. (24); leaves SO(3)
  exponential,  ///< W' = W exp(h Omega): on the group, eq. (25)
};

/// A method of integration: data, with its citation. One stepper runs them all.
struct Method {
  std::string_view name;
  Update update;
  Tableau tableau;
  int order;                 ///< observed on SO(3), which may be less than the tableau's own
  int tableau_order;         ///< of the weights, in a linear space; p in the step control
  std::string_view source;   ///< where the specification or the literature prints it
  std::string_view summary;  ///< one line for people

  bool adaptive() const { return tableau.embedded_pair; }
};

/// All methods, in the order of the specification.
std::span<const Method> methods();

std::vector<std::string> method_names();

/// The method called `name`. Throws UsageError about `what`, with the nearest name offered.
const Method& find_method(std::string_view name, const std::string& what = "method");

}  // namespace twrench
