// Parts of a study that several sections show.
#pragma once

#include <fmt/format.h>
#include <twrench/study/study.h>

#include <string>
#include <string_view>
#include <vector>

#include "report/document.h"
#include "report/results.h"

namespace twrench::report {

/// Returns a value with eight significant digits; a dash if it is not finite.
std::string digits(double value);

/// Returns an error or another small quantity with three significant digits; a dash if it is not
/// finite.
std::string brief(double value);

/// Returns three values in parentheses.
template <typename Vector>
std::string triple(const Vector& v) {
  return fmt::format("({}, {}, {})", digits(v[0]), digits(v[1]), digits(v[2]));
}

inline constexpr Phrase step_label{"Step, s", "Steg, s"};

/// Returns a method's results, which must be in the study.
const study::MethodStudy& results_of(const study::Study& study, std::string_view method);

/// Returns the measured order of a method with two decimals, or a dash if there is none.
std::string measured_order(const study::Study& study, std::string_view method);

/// Returns the errors of methods with fixed steps by step, and in the last row the measured orders.
Table ladder_table(const study::Study& study, const std::vector<std::string>& methods,
                   const Experiment& studied);

/// Returns the run in the middle of a method's ladder, or the nearest finer one that did not fail;
/// null if all failed.
const study::StudyRun* middle_run(const study::MethodStudy& method);

}  // namespace twrench::report
