#pragma once

#include <string>

#include "base/words.h"
#include "check/report/result.h"

namespace twrench::check {

// `wording` words the arguments that the reports mention.

/// Returns the report for people.
std::string check_text(const CheckResult& result, const ArgumentWording& wording);

/// Returns one object for one file; for several, {"files": [...], "order": {...}}.
std::string check_json(const CheckResult& result, const ArgumentWording& wording);

/// Returns JUnit XML for continuous-integration servers: one suite for each file, with a test case
/// for each bound or, without bounds, for whether the file follows the motion.
std::string check_junit(const CheckResult& result, const ArgumentWording& wording);

}  // namespace twrench::check
