#pragma once

#include <string>

#include "study/study.h"

namespace twrench {

// A study in words. `scene` names what was studied.

/// Tables for people.
std::string study_text(const Study& study, const std::string& scene);

/// One line a run; a value that does not exist is empty.
std::string study_csv(const Study& study);

/// Everything; a value that does not exist is null.
std::string study_json(const Study& study, const std::string& scene);

}  // namespace twrench
