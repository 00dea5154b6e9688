#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>

#include "recording/rows.h"

namespace twrench::check {

/// How strongly rows contradict the motion of a free body with some inertia: by how much the exact
/// motion from one row misses a later one, relative to the change between them. Near 0 if they
/// follow it, however inaccurately; about 1 or more if they follow another law, or are read in
/// another unit or frame than they were written in.
struct Misfit {
  std::optional<double> rates;     ///< absent if there are none, or if nothing changes
  std::optional<double> attitude;  ///< absent likewise; against the rates, if there are any

  /// The larger of the two; nothing if both are absent.
  std::optional<double> worst() const;
  /// Whether the rows follow the motion; true if nothing can be tested.
  bool fits() const;
};

/// Compares rows in order of time; some tens to hundreds suffice. Uses the interval between rows
/// with the least misfit, because short intervals suffer from rounded digits, and long ones from
/// the errors of the program that computed the rows.
Misfit misfit(const Eigen::Matrix3d& inertia, std::span<const recording::Row> rows, bool has_rates,
              bool has_attitude);

/// Misfit::rates from a few pairs of rows between which the rates change clearly: enough to tell
/// that another law or another reading is far from them, but with less margin than misfit() for
/// digits and methods.
std::optional<double> quick_misfit_of_rates(const Eigen::Matrix3d& inertia,
                                            std::span<const recording::Row> rows);

/// Misfit::attitude likewise, between which the body turns clearly.
std::optional<double> quick_misfit_of_attitude(const Eigen::Matrix3d& inertia,
                                               std::span<const recording::Row> rows,
                                               bool has_rates);

}  // namespace twrench::check
