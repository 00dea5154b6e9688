#pragma once

#include <twrench/motion/free_body.h>
#include <twrench/motion/method.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace twrench::motion {

/// The smallest meaningful tolerance: the error estimate E of a step is a difference of two
/// rotations, each known to a few 1e-16.
inline constexpr double min_tolerance = 1e-15;

/// Options that control the steps.
struct StepControl {
  /// Step size in s of a fixed-step method; initial step size of an adaptive one, limited to 0.9 of
  /// a revolution of the body.
  double step = 0.01;
  /// Error tolerance of adaptive methods: the bound on the estimate E of each step.
  double tolerance = 1e-10;
  /// Maximum number of steps of a trajectory, so that a mistake causes an error rather than a hang.
  std::int64_t max_steps = 50'000'000;
  /// If not null, stepping ends with MotionError::Reason::stopped once this is true. It lets
  /// another thread interrupt the computation. The closed form ignores it.
  const std::atomic<bool>* stop = nullptr;
};

/// An accepted step of a method.
struct AcceptedStep {
  double t;                ///< start time in s
  double length;           ///< s
  Eigen::Matrix3d before;  ///< X at the start
  Eigen::Matrix3d after;   ///< X at the end
  double error;            ///< Error estimate E of an adaptive method; otherwise 0.
};

/// Advances a motion from t = 0 with its method: step by step, series by series, or in closed form.
class Propagator final {
 public:
  /// The implementation of a method; private to the library.
  class Engine;

  /// For make_propagator().
  explicit Propagator(std::unique_ptr<Engine> engine);
  ~Propagator();
  Propagator(const Propagator&) = delete;
  Propagator& operator=(const Propagator&) = delete;

  /// Returns the sample at t, s. Throws InvalidArgument about "t" if it is not finite or lies
  /// before the last of the method's own steps; also MotionError.
  Sample sample_at(double t);

  /// Returns the samples at `times`, s. The closed form evaluates them together at a fraction of
  /// the cost, with the same bits. Throws as sample_at() does.
  std::vector<Sample> samples_at(std::span<const double> times);

  /// Returns the next of the method's own steps; the closed form, which has none, takes steps of
  /// `control.step`. Throws MotionError.
  AcceptedStep next_step();

  /// Returns the time in s at which the last of the method's own steps ends.
  double t() const;

  /// Returns the number of steps so far, including rejected ones.
  std::int64_t steps() const;
  /// Returns the number of evaluations of omega so far.
  std::int64_t evaluations() const;

 private:
  std::unique_ptr<Engine> engine_;
};

/// Whether time increases or decreases along the steps.
enum class Direction { forward, backward };

/// Returns a propagator for a method. It keeps copies of the arguments. Throws OutOfRange about a
/// step, a tolerance or a number of steps that is not allowed.
std::unique_ptr<Propagator> make_propagator(const FreeBody& body, const Method& method,
                                            const StepControl& control,
                                            Direction direction = Direction::forward);

}  // namespace twrench::motion
