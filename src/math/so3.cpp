#include <twrench/math/so3.h>

#include <cmath>

#include "math/so3_formulas.h"
#include "math/unaligned.h"

namespace twrench::so3 {

Matrix3d hat(const Vector3d& w) {
  Matrix3d Omega;
  Omega << 0, -w.z(), w.y(),  //
      w.z(), 0, -w.x(),       //
      -w.y(), w.x(), 0;
  return Omega;
}

Vector3d vee(const Matrix3d& Omega) { return {Omega(2, 1), Omega(0, 2), Omega(1, 0)}; }

AngleFunctions angle_functions(const Vector3d& u) { return Formulas::angle_functions(u); }

Vector3d exp_times(const AngleFunctions& f, const Vector3d& u, const Vector3d& v) {
  return Formulas::exp_times(f, u, v);
}

Vector3d dexpinv(const AngleFunctions& f, const Vector3d& u, const Vector3d& omega) {
  return Formulas::dexpinv(f, u, omega);
}

Matrix3d exp(const Vector3d& u) {
  const AngleFunctions f = Formulas::angle_functions(u);
  const double a = f.a, b = f.b;
  const double xx = u.x() * u.x(), yy = u.y() * u.y(), zz = u.z() * u.z();
  const double xy = b * u.x() * u.y(), xz = b * u.x() * u.z(), yz = b * u.y() * u.z();
  Matrix3d X;
  X << 1.0 - b * (yy + zz), xy - a * u.z(), xz + a * u.y(),  //
      xy + a * u.z(), 1.0 - b * (xx + zz), yz - a * u.x(),   //
      xz - a * u.y(), yz + a * u.x(), 1.0 - b * (xx + yy);
  return X;
}

Matrix3d exp(double h, const Matrix3d& Omega) { return exp(h * vee(Omega)); }

Vector3d log(const Matrix3d& X) {
  // The unit quaternion (w, v) keeps full accuracy at both ends of the range: near 0, where the
  // trace does not determine the angle, and near pi, where X - X^T vanishes.
  Quaternion q(X);
  if (q.w() < 0.0) q.coeffs() = -q.coeffs();
  Vector3d v = q.vec();
  const double sine = v.norm();
  if (sine == 0.0) return Vector3d::Zero();
  if (q.w() == 0.0) {
    for (int i = 0; i < 3; ++i) {
      if (v[i] == 0.0) continue;
      if (v[i] < 0.0) v = -v;
      break;
    }
  }
  return 2.0 * std::atan2(sine, q.w()) / sine * v;
}

}  // namespace twrench::so3
