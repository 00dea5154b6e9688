#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>

#include "check/reading/row.h"

namespace twrench::check {

/// How rows contradict the motion of a free body with some inertia: by how much the exact motion
/// from one row misses a later one, relative to how much changes between them. Near 0 where they
/// follow it, however inexactly; about 1 or more where they follow another law, or are read in
/// another unit or frame than they were written in.
struct Misfit {
  std::optional<double> rates;     ///< absent where there are none, or where nothing changes
  std::optional<double> attitude;  ///< absent likewise; against the rates, where there are any

  /// Whether the rates hardly change although they should: those of a program that leaves the
  /// gyroscopic term of Euler's equations out.
  bool constant_rates = false;

  /// The larger of the two; nothing where neither tells anything.
  std::optional<double> worst() const;
  /// Whether the rows follow the motion; also if nothing can be tested.
  bool fits() const;
};

/// Compares rows in order of time, of which some tens to hundreds suffice. Between them it takes
/// the intervals that tell most: short ones lose against rounded digits, long ones against the
/// errors of whatever computed them.
Misfit misfit(const Eigen::Matrix3d& inertia, std::span<const Row> rows, bool has_rates,
              bool has_attitude);

/// Misfit::rates alone, from at most so many pairs of rows for each interval.
std::optional<double> misfit_of_rates(const Eigen::Matrix3d& inertia, std::span<const Row> rows,
                                      std::size_t most_pairs);

/// Misfit::attitude alone, likewise.
std::optional<double> misfit_of_attitude(const Eigen::Matrix3d& inertia, std::span<const Row> rows,
                                         bool has_rates, std::size_t most_pairs);

}  // namespace twrench::check
