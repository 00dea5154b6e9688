#pragma once

#include <twrench/motion/exact.h>
#include <twrench/study/study.h>

#include <cstddef>
#include <optional>
#include <vector>

#include "plot/plots.h"
#include "report/results.h"
#include "scene/scene.h"

namespace twrench::report {

/// An experiment with its motion, exact and as the scene's method computes it.
struct Solution {
  const Experiment* experiment;
  motion::FreeBody body;
  std::optional<motion::ExactMotion> exact;  ///< Nothing unless the body is rigid.
  study::Study own;                          ///< One run of the scene's method, which did not fail.
  std::vector<motion::Sample> reference;     ///< With which it is compared, at times of a plot.

  const scene::Scene& scene() const { return experiment->scene; }
  const study::StudyRun& run() const { return own.methods.front().runs.front(); }
  /// Returns the flips of the exact motion; nothing if it has none or the body is not rigid.
  std::optional<motion::ExactMotion::Flips> flips() const;
};

/// Solves the experiment. The result refers to it. Throws MotionError if the scene's method cannot
/// compute the motion.
Solution solve(const Experiment& experiment);

/// A solution, and the same motion with rk4 as the specification prints it.
struct PrintedSolution {
  Solution solution;
  study::Study rk4;       ///< With steps from coarse to fine.
  std::size_t quiet = 0;  ///< The index of the step with which it is solved.

  const study::StudyRun& run() const { return rk4.methods.front().runs[quiet]; }
};

/// The largest relative energy drift that task 5 does not regard as noticeable.
inline constexpr double unnoticed_drift = 1e-6;

/// Solves the experiment with rk4 as well: with the longest of the study's steps whose energy drift
/// is not noticeable, or else with the shortest. Throws as solve() does, and MotionError if rk4
/// fails with all steps.
PrintedSolution solve_as_printed(const Experiment& experiment);

/// Compares all methods on the motion of an experiment, with the default steps and tolerances of
/// `twrench study`.
study::Study study_of_all(const Experiment& experiment);

/// Returns the times of a plot: enough for smooth curves, but about `most` at most.
std::vector<double> plot_times(const scene::Motion& motion, double most = 4000.0);

/// Returns the curves that `twrench plot` draws of a scene: its motion by its own method or, if it
/// shows a recorded one, that and the exact motion of the body, if it is known. Each has the flips
/// of a body that turns over. Throws as integrate() does.
std::vector<plot::AttitudeCurve> shown_curves(const scene::Scene& scene);

}  // namespace twrench::report
