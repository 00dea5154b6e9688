#pragma once

#include <twrench/math/so3.h>

#include <cmath>

namespace twrench::so3 {

/// The formulas of so3.h as inline functions. They are private so that only the library's compiler
/// flags apply to them: an inline function of a public header would also be compiled with the flags
/// of a program, and the linker would keep one of the two versions.
struct Formulas {
  static AngleFunctions angle_functions(const Vector3d& u) {
    const double half = 0.5 * u.norm();
    if (half == 0.0) return {1.0, 0.5, 1.0 / 12.0};
    const double cosine = std::cos(half);
    const double sinc = std::sin(half) / half;
    return {sinc * cosine, 0.5 * sinc * sinc, (1.0 - cosine / sinc) / (4.0 * half * half)};
  }

  static Vector3d exp_times(const AngleFunctions& f, const Vector3d& u, const Vector3d& v) {
    const Vector3d w = u.cross(v);
    return v + f.a * w + f.b * u.cross(w);
  }

  static Vector3d dexpinv(const AngleFunctions& f, const Vector3d& u, const Vector3d& omega) {
    const Vector3d w = u.cross(omega);
    return omega + 0.5 * w + f.c * u.cross(w);
  }
};

}  // namespace twrench::so3
