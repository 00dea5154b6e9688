#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "snapshot.h"

namespace twrench::torture {

/// A command to run while calls fail.
struct Scenario {
  std::string name;
  std::vector<std::string> words;  ///< the command line, without the program
  std::vector<std::string> again;  ///< the command that continues after a failure
  int code = 0;                    ///< its exit code without faults
  long memory_points = 0;          ///< maximum number of allocations that are made to fail
  bool varies = false;             ///< whether its output contains measured times
};

/// Returns all scenarios; each starts in a copy of the folder that furnish_scenarios() filled.
std::vector<Scenario> all_scenarios();

/// Creates the files that exist beforehand: frames of the same and another video, videos, pictures,
/// data. Throws std::runtime_error on failure.
void furnish_scenarios(const std::filesystem::path& folder, const std::filesystem::path& twrench);

/// A scenario's folder before, after an undisturbed run, and after one with faults.
struct Course {
  const Scenario& scenario;
  const Snapshot& before;
  const Snapshot& undisturbed;
  const Snapshot& after;
};

/// Checks the files after a run that failed: existing files must be either unchanged or complete
/// and new, and there may be no files that an undisturbed run does not leave.
std::vector<std::string> faults_in_files(const Course& course, const std::filesystem::path& folder);

/// Checks the files after a run that succeeded: they must equal those of an undisturbed run.
std::vector<std::string> faults_at_the_end(const Course& course,
                                           const std::filesystem::path& folder);

}  // namespace twrench::torture
