#pragma once

#include <twrench/motion/error.h>
#include <twrench/motion/exact.h>
#include <twrench/motion/trajectory.h>
#include <twrench/study/estimate.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace twrench::study {

/// The methods, step sizes and limits of a study.
struct StudyPlan {
  /// The methods to compare.
  std::vector<const motion::Method*> methods;
  /// Step sizes in s for the fixed-step methods.
  std::vector<double> steps;
  /// Tolerances for the adaptive methods.
  std::vector<double> tolerances;
  /// Initial step size in s of the adaptive methods.
  double first_step = 0.01;
  /// Duration of the motion in s.
  double duration = 0.0;
  /// Maximum number of steps of a run.
  std::int64_t max_steps = motion::StepControl{}.max_steps;
  /// As in StepControl.
  const std::atomic<bool>* stop = nullptr;
  /// If not empty, called with the parts of the work that are done and with their total, from one
  /// thread at a time.
  std::function<void(std::size_t done, std::size_t total)> progress = {};
};

/// One run of a method, compared with the reference.
struct StudyRun {
  /// Step size in s; for an adaptive method, the mean of the accepted ones.
  double step = 0.0;
  /// Tolerance of an adaptive method.
  std::optional<double> tolerance;
  /// Why the method failed; if set, no later field is set except `failure_reason`.
  std::string failure;
  /// The reason of the failure.
  std::optional<motion::MotionError::Reason> failure_reason = {};
  /// Frobenius norm of X - X_reference at Study::early.
  double early_error = 0.0;
  /// Frobenius norm of X - X_reference at the end.
  double error = 0.0;
  /// Largest absolute value over all steps of energy / energy(0) - 1. If the body loses energy, the
  /// energy of the reference at the same time replaces energy(0) in the difference.
  double energy_drift = 0.0;
  /// Largest value over all steps.
  double orthogonality_error = 0.0;
  /// Largest value over all steps.
  double momentum_error = 0.0;
  /// Times of the flips in the method's own solution, in s.
  std::vector<double> flips;
  /// Largest error of a flip time in s, over the flips that both solutions have; NaN if there are
  /// none.
  double flip_error = 0.0;
  /// Number of steps, including rejected ones.
  std::int64_t steps = 0;
  /// Evaluations of omega.
  std::int64_t evaluations = 0;
  /// CPU time in s for computing the sample at the end. That of a long run is extrapolated from the
  /// evaluations of its first milliseconds.
  double cpu_seconds = 0.0;
  /// Quality of the error estimate of an embedded pair.
  std::optional<EstimateQuality> estimate;
  /// Largest |energy drift| in equal parts of the duration.
  std::vector<double> drift_in_time;
};

/// All runs of a method.
struct MethodStudy {
  /// The method.
  const motion::Method* method = nullptr;
  /// Runs in the order of the plan's step sizes or tolerances.
  std::vector<StudyRun> runs;
  /// Exponent of the early error as a function of the step size.
  std::optional<double> order;
  /// Exponent of the median of true/E as a function of the step size.
  std::optional<double> estimate_exponent;
};

/// The results of a study.
struct Study {
  /// The method that computes the reference: `exact`, or `taylor` at its tightest tolerance if the
  /// motion has no closed form.
  const motion::Method* reference = nullptr;
  /// Whether the body loses energy. Flips are then not counted: the oscillation decays to
  /// round-off, whose sign changes mean nothing.
  bool loses_energy = false;
  /// Duration of the motion in s.
  double duration = 0.0;
  /// Time in s at which orders are measured: after a rotation of about 10 rad, but before flips
  /// have amplified energy errors, whose order may differ.
  double early = 0.0;
  /// The flips of the exact motion, if it has a closed form.
  std::optional<motion::ExactMotion::Flips> flips;
  /// Flip times of the reference in s, up to the duration; none if the body loses energy.
  std::vector<double> flip_times;
  /// Results by method, in the plan's order.
  std::vector<MethodStudy> methods;
};

/// Runs the study. If a method does not reach the end, for example because its steps are too long,
/// the run records the failure. Throws OutOfRange about a duration, a step or a tolerance that is
/// not allowed; InvalidArgument about "steps" if there are none, about "tolerances" if there are
/// none for an adaptive method, about "methods" if one is null, and about "method exact" if that is
/// one of them but the motion has no closed form; MotionError when it is stopped.
Study run_study(const motion::FreeBody& body, const StudyPlan& plan);

}  // namespace twrench::study
