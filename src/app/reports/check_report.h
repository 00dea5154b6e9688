#pragma once

#include <string>

#include "app/reports/check_result.h"

namespace twrench::app {

/// Returns the report for people.
std::string check_text(const CheckResult& result);

/// Returns one object for one file; for several, {"files": [...], "order": {...}}.
std::string check_json(const CheckResult& result);

/// Returns JUnit's XML, as servers for continuous integration read it: a suite for each file, with
/// a test case for each bound, or, where there is none, for whether the file follows the motion.
std::string check_junit(const CheckResult& result);

}  // namespace twrench::app
