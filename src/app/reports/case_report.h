#pragma once

#include <string>
#include <vector>

#include "cases/case.h"

namespace twrench::app {

// The list of cases, one line each, and a single case in full. Numbers in CSV and JSON, and exact
// values everywhere, have 17 significant digits.

std::string list_text(const std::vector<cases::Case>& problems);
std::string list_csv(const std::vector<cases::Case>& problems);
std::string list_json(const std::vector<cases::Case>& problems);

std::string case_text(const cases::Case& problem);
/// The exact states as a table that `check` reads.
std::string case_csv(const cases::Case& problem);
std::string case_document(const cases::Case& problem);

}  // namespace twrench::app
