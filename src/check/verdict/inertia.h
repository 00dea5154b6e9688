#pragma once

#include <Eigen/Core>
#include <span>

#include "recording/rows.h"

namespace twrench::check {

/// Changes of an inertia matrix that keep its determinant, because a free motion does not depend on
/// its size: 0 for none.
using InertiaChange = Eigen::Matrix<double, 5, 1>;

/// Of the greatest to the least principal moment that a fit considers: more than any rod's. It
/// keeps matrices positive definite after many changes.
inline constexpr double most_ratio_of_moments = 1e4;

/// Returns the inertia matrix after the change, which leaves it positive definite: the least
/// principal moment is raised if the ratio becomes too large.
Eigen::Matrix3d changed_inertia(const Eigen::Matrix3d& inertia, const InertiaChange& change);

/// An inertia matrix that was fitted to a free motion, up to its size.
struct FittedInertia {
  Eigen::Matrix3d inertia;    ///< body axes; its least principal moment is 1
  Eigen::Vector3d moments;    ///< the principal moments, ascending: 1 and two ratios
  Eigen::Vector3d deviation;  ///< their standard deviations, 0 first
  Eigen::Matrix3d axes;       ///< rotation body_from_principal; its columns are the axes
};

/// Returns the matrix in units of its least moment, with the standard deviations that follow from
/// the covariance of its changes.
FittedInertia fitted_inertia(const Eigen::Matrix3d& inertia,
                             const Eigen::Matrix<double, 5, 5>& covariance);

/// Inertia matrices with which I w + the integral of w x (I w) is about constant: the starts of
/// fits.
struct EstimatedInertia {
  Eigen::Matrix3d of_own_axes;  ///< of a body whose principal axes are those of the rows
  Eigen::Matrix3d of_any_axes;
};

/// Estimates the inertia matrices from at least two rows.
EstimatedInertia estimated_inertia(std::span<const recording::Row> rows);

}  // namespace twrench::check
