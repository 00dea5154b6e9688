#include <twrench/math/so3.h>

#include <cmath>

#include "base/require.h"
#include "math/so3_formulas.h"

namespace twrench::so3 {

Matrix3d hat(const Vector3d& w) { return Formulas::hat(require_finite_entries("w", w)); }

Vector3d vee(const Matrix3d& Omega) {
  require_finite_entries("Omega", Omega);
  return {Omega(2, 1), Omega(0, 2), Omega(1, 0)};
}

AngleFunctions angle_functions(const Vector3d& u) {
  return Formulas::angle_functions(require_finite_entries("u", u));
}

Vector3d exp_times(const AngleFunctions& f, const Vector3d& u, const Vector3d& v) {
  return Formulas::exp_times(f, require_finite_entries("u", u), require_finite_entries("v", v));
}

Vector3d dexpinv(const AngleFunctions& f, const Vector3d& u, const Vector3d& omega) {
  return Formulas::dexpinv(f, require_finite_entries("u", u),
                           require_finite_entries("omega", omega));
}

Matrix3d exp(const Vector3d& u) { return Formulas::exp(require_finite_entries("u", u)); }

Matrix3d exp(double h, const Matrix3d& Omega) {
  require_finite("h", h);
  return exp(h * vee(Omega));
}

Vector3d log(const Matrix3d& X) {
  // The unit quaternion (w, v) keeps full accuracy at both ends of the range: near 0, where the
  // trace does not determine the angle, and near pi, where X - X^T vanishes.
  Quaternion q(require_finite_entries("X", X));
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
