#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "check/verdict/inertia.h"
#include "check/verdict/problem.h"
#include "recording/rows.h"

namespace twrench::check {

/// An initial state fitted by least squares.
struct Fit {
  Reference reference;               ///< with the fitted omega and frame, from the first row's time
  Eigen::Vector3d omega_deviation;   ///< standard deviations of the fitted omega, rad/s
  Eigen::Matrix3d omega_covariance;  ///< rad^2/s^2
  std::optional<Eigen::Vector3d> frame_deviation;  ///< of the frame about the axes of space, rad
  std::optional<double> rate_residual;        ///< root mean square, component by component, rad/s
  std::optional<double> attitude_residual;    ///< likewise, rad
  std::size_t rows;                           ///< number of fitted rows
  std::optional<FittedInertia> inertia = {};  ///< if it was fitted, too
};

/// The most rows that a fit uses; longer files are thinned evenly.
inline constexpr std::size_t most_fitted_rows = 65536;

/// Fits the angular velocity at the first row, and the frame if there is an attitude, to the rates
/// in units of |omega| and to the attitudes in rad. Starts from `omega` (body axes, rad/s, at the
/// first row) and the first rows, and adds more and more rows, so that it does not converge to a
/// phase that is off by whole turns. Throws CheckError if there are fewer than two rows, `omega`
/// is zero or the rows do not determine the state, or if `stop`, which may be null, becomes true;
/// its message begins with `name`, that of the recording.
Fit fit(const std::string& name, const Eigen::Matrix3d& inertia,
        std::span<const recording::Row> rows, const Eigen::Vector3d& omega, bool has_rates,
        bool has_attitude, const std::atomic<bool>* stop = nullptr);

/// Fits the inertia matrix, up to its size, and the angular velocity at the first row to the rates.
/// The principal axes are those of the rows unless these show that they are not. Of many rows, it
/// uses about two thousand that are spread evenly. Throws CheckError if the first row is at rest or
/// the rates do not determine the ratios of the moments to a fifth.
FittedInertia fit_inertia(const std::string& name, std::span<const recording::Row> rows,
                          const std::atomic<bool>* stop = nullptr);

/// Returns the angular velocity at the first row (body axes, rad/s) with which the exact motion
/// takes the X of the first row to that of the second, by less than half a turn.
Eigen::Vector3d omega_between(const Eigen::Matrix3d& inertia, const recording::Row& first,
                              const recording::Row& second);

}  // namespace twrench::check
