#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

/// The rotation group SO(3) and its Lie algebra, with the specification's names. Each function
/// throws OutOfRange about an argument, by its name here, that is not finite.
namespace twrench::so3 {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Returns the skew-symmetric matrix of w, eq. (18): hat(w) v = w x v.
Matrix3d hat(const Vector3d& w);

/// Returns the vector of a skew-symmetric matrix, the inverse of hat. Omega must be skew-symmetric:
/// only three of its entries are read.
Vector3d vee(const Matrix3d& Omega);

/// The functions of the angle t = |u| that exp and dexpinv need, from one sine and one cosine.
struct AngleFunctions {
  double a;  ///< sin(t)/t
  double b;  ///< (1 - cos t)/t^2
  double c;  ///< (1 - (t/2) cot(t/2))/t^2 = 1/12 + t^2/720 + ...; singular at t = 2 pi
};

/// Computes the functions in half-angle form, such as b = sinc(t/2)^2/2, which loses no digits at
/// any angle, whereas 1 - cos t cancels for small t. The rounding error of c at small t is
/// harmless, because every use of c multiplies it by t^2.
AngleFunctions angle_functions(const Vector3d& u);

/// Returns exp(hat(u)) v, given the functions of |u|.
Vector3d exp_times(const AngleFunctions& f, const Vector3d& u, const Vector3d& v);

/// Returns the derivative u' of the canonical coordinates u in X = X_0 exp(hat(u)) for the body
/// angular velocity omega (X' = X hat(omega)): u' = omega + 1/2 u x omega + c u x (u x omega).
/// Valid for |u| < 2 pi. u' has the unit of omega.
///
/// This is the inverse of the left-trivialised differential of exp, and the inverse of the right
/// Jacobian J_r(u). Sources that write X = exp(hat(u)) X_0 with the spatial angular velocity
/// trivialise on the right; their dexpinv_u has -1/2 [u, omega], and ours equals their
/// dexpinv_{-u}. The names are ambiguous (the left-trivialised differential is the right Jacobian),
/// so check the sign of the commutator. Source: Munthe-Kaas, Appl. Numer. Math. 29 (1999).
Vector3d dexpinv(const AngleFunctions& f, const Vector3d& u, const Vector3d& omega);

/// Returns exp(hat(u)), eq. (21) with u = h omega: the rotation by the angle |u| in rad about u.
/// Accurate to round-off for every u, including zero.
Matrix3d exp(const Vector3d& u);

/// Returns exp(h Omega), eq. (21), for a skew-symmetric Omega in rad/s and a step size h in s.
Matrix3d exp(double h, const Matrix3d& Omega);

/// Returns the rotation vector u in rad with exp(hat(u)) = X and |u| <= pi. At |u| = pi, where both
/// u and -u are solutions, the sign follows the skew-symmetric part of X; if that part is zero, the
/// first nonzero entry of u is positive.
Vector3d log(const Matrix3d& X);

}  // namespace twrench::so3
