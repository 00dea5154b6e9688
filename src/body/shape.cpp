#include <twrench/body/shape.h>

#include <cmath>

#include "body/shape_functions.h"

namespace twrench::body {

using Eigen::Vector3d;

double volume(const Shape& shape) {
  return std::visit([](const auto& solid) { return shapes::volume(solid); }, shape);
}

Vector3d centroid(const Shape& shape) {
  return std::visit([](const auto& solid) { return shapes::centroid(solid); }, shape);
}

Eigen::Matrix3d central_inertia(const Shape& shape, double mass) {
  return std::visit([&](const auto& solid) { return shapes::central_inertia(solid, mass); }, shape);
}

double bounding_radius(const Shape& shape, const Vector3d& centre) {
  return std::visit([&](const auto& solid) { return shapes::far_side(solid, centre); }, shape);
}

Vector3d support(const Shape& shape, const Vector3d& direction) {
  const Vector3d unit = direction.stableNormalized();
  return std::visit([&](const auto& solid) { return shapes::support(solid, unit); }, shape);
}

Eigen::AlignedBox3d bounding_box(const Shape& shape) {
  Eigen::AlignedBox3d box;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) box.extend(support(shape, side * Vector3d::Unit(axis)));
  }
  return box;
}

Eigen::Matrix3d frame_with_z_along(const Vector3d& axis) {
  const Vector3d n = axis.stableNormalized();  // The square of its length may underflow.
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
