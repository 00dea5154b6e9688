#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "check/report/result.h"
#include "check/verdict/problem.h"
#include "recording/conventions/convention.h"
#include "recording/recording.h"

namespace twrench::check {

/// The bounds that a user sets for a file.
struct Bounds {
  std::optional<double> attitude_error;  ///< deg
  std::optional<double> rate_error;      ///< in the file's unit
  std::optional<double> energy_drift;    ///< relative
};

/// Judges `count` recordings of one problem, and how their errors depend on their steps. `open`
/// returns each of them; one is open at a time. `steps` has the step size of each in s; if it is
/// empty, the steps are the mean times between rows. `given` is the convention of all as far as it
/// is known. Throws as `open`, choose_convention() and judge() do, and InvalidArgument if a bound
/// is for a quantity that a recording does not have, or the number of steps is not `count`.
CheckResult check_files(std::size_t count,
                        const std::function<recording::Recording(std::size_t)>& open,
                        const std::vector<double>& steps, const recording::Convention& given,
                        const Problem& problem, const Bounds& bounds);

}  // namespace twrench::check
