#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace twrench::motion {

/// The algorithm that takes a method from one time to another. Its definition is private to the
/// library.
struct Scheme;

/// An integration method: data with its citation. One stepper runs them all.
struct Method {
  /// Name in scene files and on the command line.
  std::string_view name;
  /// Coefficients and kind of the method; never null. What it points to must outlive the method.
  const Scheme* scheme;
  std::optional<int> order;  ///< observed on SO(3), which may be less than the tableau's own; none
                             ///< for the closed form, whose error does not depend on a step
  /// Whether the energy is conserved to round-off for every step size (`taylor`: of a rigid
  /// body, up to a tolerance of 1e-8).
  bool conserves_energy;
  bool reversible;           ///< Whether a step of -h undoes a step of h, to round-off.
  std::string_view source;   ///< Reference to the specification or the literature.
  std::string_view summary;  ///< One-line description for users.

  /// Returns whether the method is the closed form, which takes no steps.
  bool exact() const;
  /// Returns whether the method chooses its own step sizes.
  bool adaptive() const;
  /// Returns whether the method leaves SO(3).
  bool linear() const;
};

/// Returns all methods: the specification's in its order, then the others by order.
std::span<const Method> methods();

/// Returns the names of all methods.
std::vector<std::string> method_names();

/// Returns the method called `name`. Throws InvalidArgument about `what`, suggesting the nearest
/// name.
const Method& find_method(std::string_view name, std::string_view what = "method");

}  // namespace twrench::motion
