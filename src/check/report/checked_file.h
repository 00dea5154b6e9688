#pragma once

#include <optional>
#include <string>
#include <vector>

#include "check/conventions/convention.h"
#include "check/report/result.h"
#include "check/verdict/problem.h"

namespace twrench::check {

/// The bounds that a user sets for a file.
struct Bounds {
  std::optional<double> attitude_error;  ///< deg
  std::optional<double> rate_error;      ///< in the file's unit
  std::optional<double> energy_drift;    ///< relative
};

/// Judges a file. `given` is its convention as far as it is known. Throws as choose_convention()
/// and judge() do, and InvalidArgument if a bound is for a quantity that the file does not have.
CheckedFile check_file(const std::string& name, const Convention& given, const Problem& problem,
                       const Bounds& bounds);

/// Returns how the errors of files depend on their steps. `has_steps` is whether the user gave
/// these.
CheckOrders orders_of(const std::vector<CheckedFile>& files, bool has_steps);

}  // namespace twrench::check
