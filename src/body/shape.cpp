#include <twrench/body/shape.h>

#include <cmath>

#include "base/require.h"
#include "body/shape_functions.h"

namespace twrench::body {

using Eigen::Vector3d;

namespace {

/// Returns the shape, or throws OutOfRange or InvalidArgument unless it is a valid solid.
const Shape& checked(const Shape& shape) {
  std::visit([](const auto& solid) { shapes::check(solid); }, shape);
  return shape;
}

/// Returns the unit vector along `vector`. Throws InvalidArgument about `quantity` if it is zero or
/// not finite.
Vector3d checked_direction(const char* quantity, const Vector3d& vector) {
  require_finite_entries(quantity, vector);
  if (vector.isZero(0.0)) throw InvalidArgument(quantity, "must not be zero");
  return vector.stableNormalized();  // The square of its length may underflow.
}

}  // namespace

double volume(const Shape& shape) {
  return std::visit([](const auto& solid) { return shapes::volume(solid); }, checked(shape));
}

Vector3d centroid(const Shape& shape) {
  return std::visit([](const auto& solid) { return shapes::centroid(solid); }, checked(shape));
}

Eigen::Matrix3d central_inertia(const Shape& shape, double mass) {
  require_positive("mass", mass);
  return std::visit([&](const auto& solid) { return shapes::central_inertia(solid, mass); },
                    checked(shape));
}

double bounding_radius(const Shape& shape, const Vector3d& centre) {
  require_finite_entries("centre", centre);
  return std::visit([&](const auto& solid) { return shapes::far_side(solid, centre); },
                    checked(shape));
}

Vector3d support(const Shape& shape, const Vector3d& direction) {
  const Vector3d unit = checked_direction("direction", direction);
  return std::visit([&](const auto& solid) { return shapes::support(solid, unit); },
                    checked(shape));
}

Eigen::AlignedBox3d bounding_box(const Shape& shape) {
  Eigen::AlignedBox3d box;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) box.extend(support(shape, side * Vector3d::Unit(axis)));
  }
  return box;
}

Eigen::Matrix3d frame_with_z_along(const Vector3d& axis) {
  const Vector3d n = checked_direction("axis", axis);
  const double sign = std::copysign(1.0, n.z());
  const double a = -1.0 / (sign + n.z());
  const double b = n.x() * n.y() * a;
  Eigen::Matrix3d frame;
  frame.col(0) = Vector3d{1.0 + sign * n.x() * n.x() * a, sign * b, -sign * n.x()};
  frame.col(1) = Vector3d{b, sign + n.y() * n.y() * a, -n.y()};
  frame.col(2) = n;
  return frame;
}

}  // namespace twrench::body
