#include <twrench/body/mass_properties.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/require.h"
#include "body/shape_functions.h"

namespace twrench::body {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using std::numbers::pi;

/// Returns the principal axes in any order: the coordinate axes themselves if they are principal.
PrincipalAxes own_axes(const Matrix3d& inertia) {
  if (inertia.isDiagonal(0.0)) return {inertia.diagonal(), Matrix3d::Identity()};
  return principal_axes(inertia);
}

/// Returns the second moments S, the integrals of x^2, y^2 and z^2 over the mass, from I_x = S_y +
/// S_z and its permutations.
Vector3d second_moments(const Vector3d& moments) {
  require_positive_entries("moments", moments);
  const double sum = moments.sum();
  const double least = 1e-6 * sum;  // Keeps a plate from having no thickness.
  return (Vector3d::Constant(sum) - 2.0 * moments).cwiseMax(least) / 2.0;
}

/// Returns the lengths l of a solid of density 1 and volume `fill` l_x l_y l_z whose second moments
/// are the mass times l_i^2 / `divisor`.
Vector3d lengths(const Vector3d& second, double fill, double divisor) {
  const double mass = std::pow(fill * std::pow(divisor, 1.5) * std::sqrt(second.prod()), 2.0 / 5.0);
  return (divisor / mass * second).cwiseSqrt();
}

/// A flat cross with discs on the ends of its arms, in units of their length.
struct Cross {
  double heavy_square;  ///< Squares of the discs' radii.
  double light_square;
  double width;      ///< Width of the arms; the hub's radius is half of it.
  double thickness;  ///< Thickness of the discs and the hub.
  double moment;     ///< The integral of x^2 over the cross, at density 1.

  /// Thickness of the arms relative to the discs. They differ so that no faces coincide.
  static constexpr double arm_share = 0.6;

  /// Makes the cross with these second moments, up to a factor. The first one is the largest; the
  /// third one is across the cross.
  explicit Cross(const Vector3d& second);
};

Cross::Cross(const Vector3d& second) {
  const double q = second.y() / second.x();
  // As large as looks good. For a body that is nearly a rod, small enough to leave some of the
  // second moment for the light discs.
  const double heavy = std::min(0.4, 2.5 * q);
  width = 2.5 * heavy * heavy * heavy;
  const double A = heavy * heavy;
  // Per thickness of the discs, the arms and the hub contribute `frame` to each of the integrals of
  // x^2 and y^2.
  const double frame =
      arm_share * width * (2.0 / 3.0 + width * width / 6.0) + pi * std::pow(width, 4) / 4.0;
  // The discs contribute 2 pi A + pi/2 (A^2 + B^2) to the integral along the heavy ones, and the
  // same with A and B exchanged to the other. The latter is q times the former, which is a
  // quadratic equation for B.
  const double a = pi / 2.0 * (1.0 - q), b = 2.0 * pi;
  const double c = (frame + pi / 2.0 * A * A) * (1.0 - q) - 2.0 * pi * q * A;
  const double B = -2.0 * c / (b + std::sqrt(b * b - 4.0 * a * c));
  const double along = frame + 2.0 * pi * A + pi / 2.0 * (A * A + B * B);
  const double across = 4.0 * width * std::pow(arm_share, 3) + pi * width * width + b * (A + B);
  heavy_square = A;
  light_square = B;
  thickness = std::sqrt(12.0 * second.z() / second.x() * along / across);
  moment = thickness * along;
}

}  // namespace

Part equimomental_box(const Matrix3d& inertia) {
  const auto& [moments, axes] = own_axes(inertia);
  // The mean square along an edge a is a^2/12.
  return {Box{lengths(second_moments(moments), 1.0, 12.0)}, 1.0, Vector3d::Zero(), axes};
}

Part equimomental_ellipsoid(const Matrix3d& inertia) {
  const auto& [moments, axes] = own_axes(inertia);
  // The mean square along a semi-axis a is a^2/5.
  return {Ellipsoid{lengths(second_moments(moments), 4.0 / 3.0 * pi, 5.0)}, 1.0, Vector3d::Zero(),
          axes};
}

std::array<Part, 7> equimomental_cross(const Matrix3d& inertia) {
  const PrincipalAxes principal = principal_axes(inertia);
  const Matrix3d& axes = principal.axes;
  const Vector3d second = second_moments(principal.moments);
  const Cross cross(second);
  const double unit = std::pow(second.x() / cross.moment, 1.0 / 5.0);
  const auto placed = [&](const Shape& shape, const Vector3d& position) {
    return Part{shape, 1.0, unit * axes * position, axes};
  };
  const auto disc = [&](double square, const Vector3d& position) {
    return placed(Cylinder{unit * std::sqrt(square), unit * cross.thickness}, position);
  };
  const double width = cross.width, flat = Cross::arm_share * cross.thickness;
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), centre = Vector3d::Zero();
  return {placed(Box{unit * Vector3d(2.0, width, flat)}, centre),
          placed(Box{unit * Vector3d(width, 2.0, flat)}, centre),
          disc(width * width, centre),
          disc(cross.heavy_square, x),
          disc(cross.heavy_square, -x),
          disc(cross.light_square, y),
          disc(cross.light_square, -y)};
}

std::array<PointMass, 6> equimomental_points(const Part& part) {
  require_part(part);
  const double mass = part.density * volume(part.shape);
  const PrincipalAxes own = own_axes(central_inertia(part.shape, mass));
  const Matrix3d body_from_own = part.body_from_part * own.axes;
  const Vector3d centre = part.position + part.body_from_part * centroid(part.shape);
  std::array<PointMass, 6> points{};
  for (Eigen::Index i = 0; i < 3; ++i) {
    // The mean square of coordinate i. The pair has a third of the mass, so that its own is three
    // times as large.
    const double mean_square = (own.moments.sum() - 2 * own.moments[i]) / (2 * mass);
    const Vector3d arm = std::sqrt(3 * std::max(mean_square, 0.0)) * body_from_own.col(i);
    points[static_cast<std::size_t>(2 * i)] = {mass / 6, centre + arm};
    points[static_cast<std::size_t>(2 * i + 1)] = {mass / 6, centre - arm};
  }
  return points;
}

}  // namespace twrench::body
