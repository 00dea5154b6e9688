#include <fmt/format.h>
#include <twrench/motion/free_body.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "base/require.h"
#include "math/unaligned.h"

namespace twrench::motion {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

body::PrincipalAxes positive_axes(const Matrix3d& inertia) {
  body::PrincipalAxes principal = body::principal_axes(inertia);
  const double least = principal.moments[0];
  if (least > 0) return principal;
  throw OutOfRange("inertia",
                   fmt::format("must be positive definite, but its least moment is {}", least),
                   {least, 0, std::numeric_limits<double>::max()});
}

/// By way of moments near 1, so that the determinant neither overflows nor underflows. The unit is
/// a power of two, so that nothing is rounded.
Matrix3d inverse_of(const Matrix3d& inertia, double greatest_moment) {
  const int exponent = -std::ilogb(greatest_moment);
  const auto scaled = [exponent](double entry) { return std::ldexp(entry, exponent); };
  return inertia.unaryExpr(scaled).inverse().unaryExpr(scaled);
}

}  // namespace

FreeBody::FreeBody(const Matrix3d& inertia, const Vector3d& omega, const Matrix3d& attitude)
    : inertia_(inertia),
      principal_(positive_axes(inertia)),
      inverse_(inverse_of(inertia, principal_.moments[2])) {
  if (!inverse_.allFinite()) {
    throw InvalidArgument("inertia", "its inverse is beyond what double precision holds");
  }
  set_start(omega, attitude);
}

FreeBody FreeBody::with_omega(const Vector3d& omega) const { return with_start(omega, attitude_); }

FreeBody FreeBody::with_start(const Vector3d& omega, const Matrix3d& attitude) const {
  FreeBody body(*this);
  body.set_start(omega, attitude);
  return body;
}

[[gnu::flatten]] void FreeBody::set_start(const Vector3d& omega, const Matrix3d& attitude) {
  for (const double component : omega) require_finite("omega", component);
  omega_ = omega;
  body_momentum_ = inertia_ * omega;
  if (!body_momentum_.allFinite()) {
    throw InvalidArgument("omega", "the angular momentum is beyond what double precision holds");
  }
  if (!std::isfinite(body_momentum_.dot(omega_))) {
    throw InvalidArgument("omega", "the energy is beyond what double precision holds");
  }
  attitude_ = attitude;
  momentum_ = body_momentum_;
  if (attitude == Matrix3d::Identity()) return;
  constexpr double round_off = 1e-9;
  if (!attitude.isUnitary(round_off) || !(attitude.determinant() > 0)) {
    throw InvalidArgument("attitude", "must be a proper rotation");
  }
  momentum_ = attitude * body_momentum_;
}

Eigen::Quaternion<double, Eigen::DontAlign> Sample::quaternion() const {
  for (const double entry : X.reshaped()) require_finite("X", entry);
  so3::Quaternion q(X);
  q.normalize();
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  return q;
}

}  // namespace twrench::motion
