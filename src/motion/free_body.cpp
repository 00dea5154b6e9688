#include <fmt/format.h>
#include <twrench/motion/free_body.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "base/require.h"

namespace twrench::motion {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d finite_omega(const Vector3d& omega) {
  for (const double component : omega) require_finite("omega", component);
  return omega;
}

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

FreeBody::FreeBody(const Matrix3d& inertia, const Vector3d& omega)
    : inertia_(inertia),
      omega_(finite_omega(omega)),
      principal_(positive_axes(inertia)),
      inverse_(inverse_of(inertia, principal_.moments[2])),
      momentum_(inertia * omega) {
  if (!inverse_.allFinite()) {
    throw InvalidArgument("inertia", "its inverse is beyond what double precision holds");
  }
  if (!momentum_.allFinite()) {
    throw InvalidArgument("omega", "the angular momentum is beyond what double precision holds");
  }
  if (!std::isfinite(momentum_.dot(omega_))) {
    throw InvalidArgument("omega", "the energy is beyond what double precision holds");
  }
}

}  // namespace twrench::motion
