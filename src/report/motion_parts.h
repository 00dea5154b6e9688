#pragma once

#include <string>
#include <vector>

#include "report/document.h"
#include "report/solution.h"

// The parts of the report on a motion, whether it belongs to the tasks or not.
namespace twrench::report {

/// A numerical solution of an experiment.
struct NumericalSolution {
  std::string name;            ///< Its method and step or tolerance.
  const study::StudyRun* run;  ///< Not null.
  std::string command;         ///< The command line that prints its numbers.
};

/// The solution by the scene's own method.
NumericalSolution own_solution(const Solution& solution);

/// The solution by rk4, with the step that was chosen.
NumericalSolution rk4_solution(const PrintedSolution& solution);

/// The constants of the motion.
Table constants_table(const Solution& solution);

/// The flips of the exact motion and those of the solutions. There must be at least one solution.
Table flips_table(const Solution& solution, const std::vector<NumericalSolution>& solutions);

/// How far the solutions drift.
Table drift_table(const Solution& solution, const std::vector<NumericalSolution>& solutions);

/// The nine components of X at samples, with the flips of the exact motion.
Figure components_figure(const Solution& solution, std::vector<motion::Sample> samples,
                         std::string command);

/// An interpretation of the nine components in words.
std::string interpretation(const Solution& solution);

}  // namespace twrench::report
