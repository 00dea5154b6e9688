#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "motion/exact.h"
#include "motion/trajectory.h"
#include "study/estimate.h"

namespace twrench {

/// What is to be tried.
struct StudyPlan {
  std::vector<const Method*> methods;
  std::vector<double> steps;                         ///< s, of the methods with a fixed step
  std::vector<double> tolerances;                    ///< of the adaptive methods
  double first_step = 0.01;                          ///< s, of the adaptive methods
  double duration = 0.0;                             ///< s
  std::int64_t max_steps = StepControl{}.max_steps;  ///< of one run
};

/// One motion by one method, held against the exact one.
struct StudyRun {
  double step = 0.0;                ///< s; the mean of the accepted ones of an adaptive method
  std::optional<double> tolerance;  ///< of an adaptive method
  std::string failure;              ///< why the method refused; then nothing below is set
  double early_error = 0.0;         ///< Frobenius norm of X - X_exact at Study::early
  double error = 0.0;               ///< Frobenius norm of X - X_exact at the end
  double energy_drift = 0.0;        ///< the largest of each of these over the steps, absolute
  double orthogonality_error = 0.0;
  double momentum_error = 0.0;
  std::vector<double> flips;     ///< s, as the method sees them
  double flip_error = 0.0;       ///< s, the largest of those that can be compared; NaN: none
  std::int64_t steps = 0;        ///< rejected ones too
  std::int64_t evaluations = 0;  ///< of omega
  double cpu_seconds = 0.0;      ///< for the sample at the end
  std::optional<EstimateQuality> estimate;  ///< of an embedded pair
  std::vector<double> drift_in_time;  ///< largest |energy drift| in equal parts of the duration
};

struct MethodStudy {
  const Method* method = nullptr;
  std::vector<StudyRun> runs;               ///< in the order of the plan's steps or tolerances
  std::optional<double> order;              ///< exponent of the early error over the step
  std::optional<double> estimate_exponent;  ///< that of the median of true/E over the step
};

struct Study {
  double duration = 0.0;  ///< s
  /// s: where orders are measured, about 10 rad from the start, before flips have magnified an
  /// error of the energy, which may have another order
  double early = 0.0;
  std::optional<ExactMotion::Flips> flips;  ///< predicted
  std::vector<double> flip_times;           ///< s, predicted, up to the duration
  std::vector<MethodStudy> methods;
};

/// Runs them all. A method that does not get to the end, of steps that are too long for it, say, is
/// a run with a failure. Throws OutOfRange about a duration, a step or a tolerance that cannot be,
/// UsageError where there are no steps.
Study study(const FreeBody& body, const StudyPlan& plan);

}  // namespace twrench
