#pragma once

#include <twrench/motion/exact.h>

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "check/verdict/problem.h"

namespace twrench::check {

/// A sign change of the component of omega along the intermediate axis.
struct SignChange {
  double t;  ///< s
  bool up;   ///< from negative to positive
};

/// A flip in the file and the corresponding exact one. Either may be missing.
struct Flip {
  std::optional<double> found, exact;  ///< s, on the file's clock
};

/// Finds the flips of a recorded trajectory. Between rows it follows the exact motion through the
/// previous row. A sign change counts once the component exceeds a small part of its amplitude,
/// because noise near zero may cause several changes instead of one.
class FlipFinder {
 public:
  /// The most flips that are kept; later ones are dropped.
  static constexpr std::size_t most = 100'000;

  /// Uses the inertia and the amplitude of the reference's motion.
  explicit FlipFinder(const Reference& reference);

  /// Adds the rates (body axes, rad/s) at the next time t in s.
  void add(double t, const Eigen::Vector3d& omega);

  /// Ends the search, and returns the flips in order of time. Call it after all rows are added.
  std::vector<SignChange> finish();

 private:
  void keep(const SignChange& change);
  double crossing(double t, double component) const;

  Eigen::Matrix3d inertia_;
  Eigen::Vector3d axis_;  ///< the intermediate axis, in body axes
  double threshold_ = 0;  ///< rad/s
  bool has_axis_;         ///< whether there is an intermediate axis
  double side_ = 0;  ///< sign of the component at first, later when it last exceeded the threshold
  std::optional<double> at_;  ///< time at which it crossed zero since then
  double last_t_ = 0;
  Eigen::Vector3d last_omega_ = Eigen::Vector3d::Zero();
  std::vector<SignChange> found_;
};

/// Returns the sign changes of the exact motion with from < t <= to, in s on the file's clock.
std::vector<SignChange> exact_flips(const Reference& reference, double from, double to);

/// Pairs the flips of a file with the exact ones, in order: the n-th with the n-th of the same
/// direction.
std::vector<Flip> paired(const std::vector<SignChange>& found,
                         const std::vector<SignChange>& exact);

}  // namespace twrench::check
