#pragma once

#include <twrench/study/study.h>

#include <string>

namespace twrench::app {

// Reports of a study. `scene` names the scene that was studied.

/// Returns tables for people to read.
std::string study_text(const study::Study& study, const std::string& scene);

/// Returns CSV with one line per run; a missing value is empty.
std::string study_csv(const study::Study& study);

/// Returns JSON with all results; a missing value is null.
std::string study_json(const study::Study& study, const std::string& scene);

}  // namespace twrench::app
