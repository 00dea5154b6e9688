#include <fmt/format.h>
#include <twrench/motion/free_body.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "base/require.h"
#include "math/so3_formulas.h"
#include "motion/unchecked.h"

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

/// Returns the inverse, computed with moments near 1, so that the determinant neither overflows nor
/// underflows. The unit is a power of two, so nothing is rounded.
Matrix3d inverse_of(const Matrix3d& inertia, double greatest_moment) {
  const int exponent = -std::ilogb(greatest_moment);
  const auto scaled = [exponent](double entry) { return std::ldexp(entry, exponent); };
  return inertia.unaryExpr(scaled).inverse().unaryExpr(scaled);
}

constexpr double never = std::numeric_limits<double>::infinity();

/// Returns the coefficient a for the time constant tau of a nutation about the axis of greatest
/// moment, in a body with the momentum G. Near that axis m1' = -a G^2 p m1 + G q m2 and m2' = -a
/// G^2 q m2 - G p m1 with p = 1/I1 - 1/I3 and q = 1/I2 - 1/I3 (docs/theory.md). Both eigenvalues
/// have the real part -1/tau as long as they are complex. Not inlined, because FreeBody::set_start
/// inlines everything else: the formatting of the message would take minutes to compile.
[[gnu::noinline]] double energy_loss_of(double tau, const Vector3d& moments, double G) {
  if (tau == never) return 0;
  require_positive("energy_loss_time", tau);
  const double p = 1 / moments[0] - 1 / moments[2], q = 1 / moments[1] - 1 / moments[2];
  constexpr double same = 1e-12;
  if (!(q * moments[1] > same)) {
    throw InvalidArgument("energy_loss_time", "the body has no single axis of greatest moment",
                          "leave it out");
  }
  if (G == 0) return 0;
  const double least = (p - q) / (p + q) / (G * std::sqrt(p * q));
  if (tau > least) return 2 / (tau * G * (p + q)) / G;
  throw OutOfRange("energy_loss_time",
                   fmt::format("is {} s, but must be above {} s: below it a nutation decays more "
                               "slowly and without oscillating",
                               tau, least),
                   {tau, least, never});
}

}  // namespace

FreeBody::FreeBody(const Matrix3d& inertia, const Vector3d& omega, const Matrix3d& attitude,
                   const Interior& interior)
    : inertia_(inertia),
      principal_(positive_axes(inertia)),
      inverse_(inverse_of(inertia, principal_.moments[2])),
      interior_(interior),
      is_rigid_(interior.wheel.isZero(0.0) && interior.energy_loss_time == never) {
  if (!inverse_.allFinite()) {
    throw InvalidArgument("inertia", "its inverse exceeds the range of a double");
  }
  require_finite_entries("wheel", interior.wheel);
  set_start(omega, attitude);
}

FreeBody FreeBody::with_omega(const Vector3d& omega) const { return with_start(omega, attitude_); }

FreeBody FreeBody::with_start(const Vector3d& omega, const Matrix3d& attitude) const {
  FreeBody body(*this);
  body.set_start(omega, attitude);
  return body;
}

[[gnu::flatten]] void FreeBody::set_start(const Vector3d& omega, const Matrix3d& attitude) {
  require_finite_entries("omega", omega);
  omega_ = omega;
  body_momentum_ = inertia_ * omega;
  if (!is_rigid_) body_momentum_ += interior_.wheel;
  if (!body_momentum_.allFinite()) {
    throw InvalidArgument("omega", "the angular momentum exceeds the range of a double");
  }
  if (!std::isfinite(body_momentum_.dot(omega_))) {
    throw InvalidArgument("omega", "the energy exceeds the range of a double");
  }
  const double most = body_momentum_.stableNorm() + interior_.wheel.stableNorm();
  if (!is_rigid_ && !std::isfinite(most * (most / principal_.moments[0]))) {
    throw InvalidArgument("wheel", "the energy exceeds the range of a double");
  }
  energy_loss_ =
      energy_loss_of(interior_.energy_loss_time, principal_.moments, body_momentum_.stableNorm());
  attitude_ = attitude;
  momentum_ = body_momentum_;
  if (attitude == Matrix3d::Identity()) return;
  constexpr double round_off = 1e-9;
  if (!attitude.isUnitary(round_off) || !(attitude.determinant() > 0)) {
    throw InvalidArgument("attitude", "must be a proper rotation");
  }
  momentum_ = attitude * body_momentum_;
}

Vector3d FreeBody::rigid_velocity(const Vector3d& m) const {
  return unchecked::rigid_velocity(*this, require_finite_entries("m", m));
}

Vector3d FreeBody::turning_rate(const Vector3d& m) const {
  return unchecked::turning_rate(*this, require_finite_entries("m", m));
}

double FreeBody::fastest_rate() const {
  const double G = momentum_.stableNorm();
  return (G + interior_.wheel.stableNorm()) / principal_.moments[0] * (1 + energy_loss_ * G);
}

Vector3d FreeBody::initial_rate() const {
  return energy_loss_ == 0 ? omega_
                           : Vector3d(omega_ + energy_loss_ * body_momentum_.cross(omega_));
}

double FreeBody::energy(const Vector3d& m) const {
  return 0.5 * rigid_velocity(m).dot(m - interior_.wheel);
}

Eigen::Quaternion<double, Eigen::DontAlign> Sample::quaternion() const {
  require_finite_entries("X", X);
  so3::Quaternion q(X);
  q.normalize();
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  return q;
}

}  // namespace twrench::motion
