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

/// Judges files of one problem, and how their errors depend on their steps. `steps` has the step
/// size of each file in s; if it is empty, the steps are the mean times between rows. `given` is
/// the convention of the files as far as it is known. Throws as choose_convention() and judge() do,
/// and InvalidArgument if a bound is for a quantity that a file does not have, or the number of
/// steps is not that of the files.
CheckResult check_files(const std::vector<std::string>& names, const std::vector<double>& steps,
                        const Convention& given, const Problem& problem, const Bounds& bounds);

}  // namespace twrench::check
