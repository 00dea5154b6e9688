#pragma once

#include <Eigen/Core>

/// The rotation group SO(3) and its Lie algebra, in the specification's names.
namespace twrench::so3 {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// The skew matrix of w, eq. (18): hat(w) v = w x v.
Matrix3d hat(const Vector3d& w);

/// The inverse of hat. Omega must be skew: only its lower triangle's signs are read.
Vector3d vee(const Matrix3d& Omega);

/// exp(hat(u)), eq. (21) with u = h omega: the rotation by the angle |u| about u.
/// Accurate to round-off for every |u|, zero included.
Matrix3d exp(const Vector3d& u);

/// exp(h Omega), eq. (21), for a skew Omega [1/s] and a step h [s].
Matrix3d exp(double h, const Matrix3d& Omega);

/// The u with exp(hat(u)) = X and |u| <= pi. At |u| = pi, where u and -u are both right, the sign
/// follows the part of X that is skew; if that part is zero, the first nonzero entry is positive.
Vector3d log(const Matrix3d& X);

}  // namespace twrench::so3
