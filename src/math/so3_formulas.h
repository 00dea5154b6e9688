#pragma once

#include <twrench/math/so3.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>

namespace twrench::so3 {

/// The formulas of so3.h as inline functions. They do not check their arguments; numbers that are
/// not finite give NaN. They are private so that only the library's compiler flags apply to them.
/// An inline function of a public header would also be compiled with the flags of a program, and
/// the linker would keep only one of the two versions.
struct Formulas {
  static Matrix3d hat(const Vector3d& w) {
    Matrix3d Omega;
    Omega << 0, -w.z(), w.y(),  //
        w.z(), 0, -w.x(),       //
        -w.y(), w.x(), 0;
    return Omega;
  }

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

  static Matrix3d exp(const Vector3d& u) {
    const AngleFunctions f = angle_functions(u);
    const double a = f.a, b = f.b;
    const double xx = u.x() * u.x(), yy = u.y() * u.y(), zz = u.z() * u.z();
    const double xy = b * u.x() * u.y(), xz = b * u.x() * u.z(), yz = b * u.y() * u.z();
    Matrix3d X;
    X << 1.0 - b * (yy + zz), xy - a * u.z(), xz + a * u.y(),  //
        xy + a * u.z(), 1.0 - b * (xx + zz), yz - a * u.x(),   //
        xz - a * u.y(), yz + a * u.x(), 1.0 - b * (xx + yy);
    return X;
  }
};

// The alignment of Eigen's own types of these sizes depends on compiler flags. The linker may merge
// an inline function of Eigen in the library with the same function in a program, which may have
// been compiled with other flags. A function of the types below assumes no alignment in either
// build.

/// A quaternion whose layout is independent of compiler flags.
using Quaternion = Eigen::Quaternion<double, Eigen::DontAlign>;

/// A 4 x 4 matrix whose layout is independent of compiler flags.
using Matrix4 = Eigen::Matrix<double, 4, 4, Eigen::DontAlign>;

}  // namespace twrench::so3
