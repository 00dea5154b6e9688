#include <fmt/format.h>
#include <twrench/body/mass_properties.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include "base/require.h"
#include "body/shape_functions.h"

namespace twrench::body {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Flips the columns so that their signs do not depend on the eigenvalue solver.
Matrix3d with_definite_signs(Matrix3d axes) {
  for (int i = 0; i < 2; ++i) {
    Eigen::Index largest = 0;
    axes.col(i).cwiseAbs().maxCoeff(&largest);
    if (axes(largest, i) < 0.0) axes.col(i) = -axes.col(i);
  }
  axes.col(2) = axes.col(0).cross(axes.col(1));
  return axes;
}

/// Throws unless it is finite and, to round-off, symmetric.
void check(const Matrix3d& inertia) {
  constexpr double round_off = 1e-12;
  require_finite_entries("inertia", inertia);
  const double asymmetry = (inertia - inertia.transpose()).cwiseAbs().maxCoeff();
  if (asymmetry <= round_off * inertia.cwiseAbs().maxCoeff()) return;
  throw InvalidArgument("inertia",
                        fmt::format("must be symmetric, but two entries that should be equal "
                                    "are {} apart",
                                    asymmetry));
}

// The callers check the parts.

double mass_of(const Part& part) {
  return part.density *
         std::visit([](const auto& solid) { return shapes::volume(solid); }, part.shape);
}

/// Returns the centre of mass of a part in cm, in the frame in which the part is placed.
Vector3d centroid_of(const Part& part) {
  return part.position +
         part.body_from_part *
             std::visit([](const auto& solid) { return shapes::centroid(solid); }, part.shape);
}

Matrix3d inertia_of(const Part& part) {
  const double mass = mass_of(part);
  return std::visit([&](const auto& solid) { return shapes::central_inertia(solid, mass); },
                    part.shape);
}

/// Returns the inertia about the origin of a point mass at d, the second term of the parallel-axis
/// theorem.
Matrix3d point_inertia(double mass, const Vector3d& d) {
  return mass * (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose());
}

}  // namespace

// Eigen's functions are inlined here. Otherwise the linker may replace them by those of a program
// that is compiled with -ffast-math, which might accept a NaN.
[[gnu::flatten]] void require_part(const Part& part) {
  std::visit([](const auto& solid) { shapes::check(solid); }, part.shape);
  require_positive("density", part.density);
  require_finite_entries("position", part.position);
  constexpr double round_off = 1e-9;
  const Matrix3d& R = part.body_from_part;
  if (!R.isUnitary(round_off) || !(R.determinant() > 0)) {
    throw InvalidArgument("body_from_part", "must be a proper rotation");
  }
}

Matrix3d inertia_about(const MassProperties& body, const Vector3d& point) {
  return body.inertia + point_inertia(body.mass, point - body.centre_of_mass);
}

MassProperties mass_properties(std::span<const Part> parts) {
  if (parts.empty()) throw InvalidArgument("parts", "there must be one at least");
  for (const Part& part : parts) require_part(part);
  MassProperties body{};
  body.centre_of_mass.setZero();
  body.inertia.setZero();
  for (const Part& part : parts) {
    const double mass = mass_of(part);
    body.mass += mass;
    body.centre_of_mass += mass * centroid_of(part);  // Eq. (44), divided by the mass below.
  }
  body.centre_of_mass /= body.mass;
  for (const Part& part : parts) {
    const Matrix3d& R = part.body_from_part;
    body.inertia += R * inertia_of(part) * R.transpose() +
                    point_inertia(mass_of(part), centroid_of(part) - body.centre_of_mass);
  }
  if (!body.inertia.allFinite()) {
    throw InvalidArgument("parts", "their inertia exceeds the range of a double");
  }
  const PrincipalAxes principal = principal_axes(body.inertia);
  body.moments = principal.moments;
  body.axes = principal.axes;
  return body;
}

PrincipalAxes principal_axes(const Matrix3d& inertia) {
  check(inertia);
  if (inertia.isDiagonal(0.0)) {  // The solver would round the last digit.
    std::array<Eigen::Index, 3> order{0, 1, 2};
    std::ranges::stable_sort(order, {}, [&](Eigen::Index i) { return inertia(i, i); });
    PrincipalAxes result{Vector3d::Zero(), Matrix3d::Zero()};
    for (Eigen::Index i = 0; i < 3; ++i) {
      const Eigen::Index from = order[static_cast<std::size_t>(i)];
      result.moments[i] = inertia(from, from);
      result.axes(from, i) = 1.0;
    }
    result.axes = with_definite_signs(result.axes);
    return result;
  }
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(inertia);
  return {solver.eigenvalues(), with_definite_signs(solver.eigenvectors())};
}

}  // namespace twrench::body
