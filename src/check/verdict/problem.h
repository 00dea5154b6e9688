#pragma once

#include <twrench/motion/free_body.h>

#include <Eigen/Core>
#include <optional>

namespace twrench::check {

/// From what a file's space frame is found, which is its own: X_file = R X_exact.
enum class FrameFrom {
  first,     ///< the attitude of the first row
  momentum,  ///< the mean direction of L over all rows; the angle about L is that of the first row
};

/// What a recorded trajectory is held against.
struct Problem {
  /// Body axes, positive definite; in any unit, for only its ratios matter to the motion.
  Eigen::Matrix3d inertia;
  /// At `omega_time`, body axes, rad/s. Absent: that of the first row, at its time. With `fit` it
  /// is where the fit begins.
  std::optional<Eigen::Vector3d> omega = {};
  /// On the file's clock, s. Absent: that of the first row.
  std::optional<double> omega_time = 0;
  /// Whether the initial state is fitted to all rows by least squares.
  bool fit = false;
  FrameFrom frame = FrameFrom::first;
};

/// The exact motion on the clock and in the space frame of a file.
struct Reference {
  motion::FreeBody body;                                ///< with omega at `start`
  double start = 0;                                     ///< s, as the file counts
  Eigen::Matrix3d frame = Eigen::Matrix3d::Identity();  ///< R above, with X_exact(start) = Id
};

}  // namespace twrench::check
