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

/// A flip of the file and the exact one of the same number and direction. Either may be missing.
struct Flip {
  std::optional<double> found, exact;  ///< s, as the file counts
};

/// Finds the flips of a recorded trajectory, between rows on the exact motion that goes through the
/// row before. A sign change counts when the component has gone beyond a small part of its swing:
/// before that, noise may make several of one.
class FlipFinder {
 public:
  /// Of more than that many flips only the first are kept.
  static constexpr std::size_t most = 100'000;

  /// Begins with the reference's motion, whose inertia and swing it takes.
  explicit FlipFinder(const Reference& reference);

  /// Takes the rates (body axes, rad/s) at the next time t in s.
  void add(double t, const Eigen::Vector3d& omega);

  /// Ends the search; the flips so far, in order of time. Whoever asks has added all rows.
  std::vector<SignChange> finish();

 private:
  void keep(const SignChange& change);
  double crossing(double t, double component) const;

  Eigen::Matrix3d inertia_;
  Eigen::Vector3d axis_;  ///< the intermediate one, in body axes
  double threshold_ = 0;  ///< rad/s
  bool has_axis_;         ///< whether there is an intermediate axis
  double side_ = 0;  ///< sign of the component at first, and then when it was beyond the threshold
  std::optional<double> at_;  ///< where it crossed zero since then
  double last_t_ = 0;
  Eigen::Vector3d last_omega_ = Eigen::Vector3d::Zero();
  std::vector<SignChange> found_;
};

/// Returns the sign changes of the exact motion with from < t <= to, s on the file's clock.
std::vector<SignChange> exact_flips(const Reference& reference, double from, double to);

/// Pairs the flips of a file with the exact ones, in order: the n-th with the n-th of the same
/// direction.
std::vector<Flip> paired(const std::vector<SignChange>& found,
                         const std::vector<SignChange>& exact);

}  // namespace twrench::check
