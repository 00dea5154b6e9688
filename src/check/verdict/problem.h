#pragma once

#include <twrench/motion/free_body.h>

#include <Eigen/Core>
#include <atomic>
#include <optional>

namespace twrench::check {

/// How the space frame of a file is found. It differs from that of the exact motion by a rotation:
/// X_file = R X_exact.
enum class FrameSource {
  first,     ///< the attitude of the first row
  momentum,  ///< the mean direction of L over all rows; the angle about L is that of the first row
};

/// The motion that a recorded trajectory is compared with.
struct Problem {
  /// Body axes, positive definite, in any unit, because the motion depends only on the ratios. Set
  /// by check_files() if it is fitted.
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Identity();
  /// At `omega_time`, body axes, rad/s. If absent, that of the first row at its time. With `fit`,
  /// the start of the fit.
  std::optional<Eigen::Vector3d> omega = {};
  /// On the file's clock, s. If absent, that of the first row.
  std::optional<double> omega_time = 0;
  /// Whether the initial state is fitted to all rows by least squares. It always is if there are
  /// neither rates nor `omega`.
  bool fit = false;
  /// Whether check_files() fits the inertia to the rates of each file; then `fit` applies, too.
  bool fits_inertia = false;
  FrameSource frame = FrameSource::first;
  /// If it becomes true, the check ends with a CheckError. May be null.
  const std::atomic<bool>* stop = nullptr;
};

/// The exact motion in the space frame of a file.
struct Reference {
  motion::FreeBody body;                                ///< with omega at `start`
  double start = 0;                                     ///< s since the first row
  Eigen::Matrix3d frame = Eigen::Matrix3d::Identity();  ///< R above, with X_exact(start) = Id
};

}  // namespace twrench::check
