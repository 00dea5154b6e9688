#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "snapshot.h"

namespace twrench::torture {

/// What is done while calls fail.
struct Scenario {
  std::string name;
  std::vector<std::string> words;  ///< the command line, without the program
  std::vector<std::string> again;  ///< that with which one goes on after a failure
  int code = 0;                    ///< with which it ends undisturbed
  long memory_points = 0;          ///< how many of its allocations are made to fail, at most
  bool varies = false;             ///< what it writes holds measured times
};

/// All of them, by what the program takes, which is asked in the folder; each begins in a copy of
/// the folder that furnish_scenarios() filled.
std::vector<Scenario> all_scenarios(const std::filesystem::path& twrench,
                                    const std::filesystem::path& scratch);

/// What was made before: frames of the film and of another, films, pictures, data. Throws
/// std::runtime_error where that cannot be made.
void furnish_scenarios(const std::filesystem::path& folder, const std::filesystem::path& twrench);

/// A scenario's folder before, after an undisturbed run, and after one in which calls failed.
struct Course {
  const Scenario& scenario;
  const Snapshot& before;
  const Snapshot& undisturbed;
  const Snapshot& after;
};

/// What is wrong with the files after a run that failed: what stood there is neither as it was nor
/// whole and new; something is there that an undisturbed run does not leave.
std::vector<std::string> faults_in_files(const Course& course, const std::filesystem::path& folder);

/// What is wrong with them after one that did not: they differ from an undisturbed run's.
std::vector<std::string> faults_at_the_end(const Course& course,
                                           const std::filesystem::path& folder);

}  // namespace twrench::torture
