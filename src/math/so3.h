#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>

/// The rotation group SO(3) and its Lie algebra, in the specification's names.
namespace twrench::so3 {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// The skew matrix of w, eq. (18): hat(w) v = w x v.
Matrix3d hat(const Vector3d& w);

/// The inverse of hat. Omega must be skew: only its lower triangle's signs are read.
Vector3d vee(const Matrix3d& Omega);

/// The functions of the angle t = |u| that exp and dexpinv need, with one sine and one cosine.
struct AngleFunctions {
  double a;  ///< sin(t)/t
  double b;  ///< (1 - cos t)/t^2
  double c;  ///< (1 - (t/2) cot(t/2))/t^2 = 1/12 + t^2/720 + ...; singular at t = 2 pi
};

/// Half-angle forms, b = sinc(t/2)^2/2 and so on, lose no digits for any angle, where 1 - cos t
/// would for small ones. What rounds in c for small t is multiplied by t^2 wherever c is used.
inline AngleFunctions angle_functions(const Vector3d& u) {
  const double half = 0.5 * u.norm();
  if (half == 0.0) return {1.0, 0.5, 1.0 / 12.0};
  const double cosine = std::cos(half);
  const double sinc = std::sin(half) / half;
  return {sinc * cosine, 0.5 * sinc * sinc, (1.0 - cosine / sinc) / (4.0 * half * half)};
}

/// exp(hat(u)) v, given the functions of |u|.
inline Vector3d exp_times(const AngleFunctions& f, const Vector3d& u, const Vector3d& v) {
  const Vector3d w = u.cross(v);
  return v + f.a * w + f.b * u.cross(w);
}

/// The derivative u' of canonical coordinates, X = X_0 exp(hat(u)), whose body velocity is omega:
/// omega + 1/2 u x omega + c u x (u x omega), with the signs of body velocities and the exponential
/// on the right. Source: Munthe-Kaas, Appl. Numer. Math. 29 (1999). Valid for |u| < 2 pi.
inline Vector3d dexpinv(const AngleFunctions& f, const Vector3d& u, const Vector3d& omega) {
  const Vector3d w = u.cross(omega);
  return omega + 0.5 * w + f.c * u.cross(w);
}

/// exp(hat(u)), eq. (21) with u = h omega: the rotation by the angle |u| about u.
/// Accurate to round-off for every |u|, zero included.
Matrix3d exp(const Vector3d& u);

/// exp(h Omega), eq. (21), for a skew Omega [1/s] and a step h [s].
Matrix3d exp(double h, const Matrix3d& Omega);

/// The u with exp(hat(u)) = X and |u| <= pi. At |u| = pi, where u and -u are both right, the sign
/// follows the part of X that is skew; if that part is zero, the first nonzero entry is positive.
Vector3d log(const Matrix3d& X);

}  // namespace twrench::so3
