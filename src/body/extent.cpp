#include <twrench/body/shape.h>

#include <algorithm>
#include <cmath>

namespace twrench::body {
namespace {

using Eigen::Vector3d;

Vector3d at_height(double z) { return {0.0, 0.0, z}; }

/// A point at `radius` from the z axis, on the side of `direction`; along x if that is the axis.
Vector3d beside_axis(double radius, const Vector3d& direction) {
  const double length = std::hypot(direction.x(), direction.y());
  if (length == 0.0) return {radius, 0.0, 0.0};
  return {radius * direction.x() / length, radius * direction.y() / length, 0.0};
}

/// The point farthest along a unit vector.
struct Support {
  Vector3d direction;

  Vector3d operator()(const Cylinder& c) const { return of_cylinder(c.radius, c.length); }
  Vector3d operator()(const Tube& t) const { return of_cylinder(t.radius, t.length); }
  Vector3d operator()(const Box& b) const {
    return (b.size.array() / 2.0 * direction.array().sign()).matrix();
  }
  Vector3d operator()(const Ellipsoid& e) const {
    return e.radii.cwiseProduct(e.radii.cwiseProduct(direction).normalized());
  }
  Vector3d operator()(const Cone& c) const {
    const Vector3d base = beside_axis(c.radius, direction) + at_height(-c.length / 2.0);
    const Vector3d top = beside_axis(c.top_radius, direction) + at_height(c.length / 2.0);
    return direction.dot(base) > direction.dot(top) ? base : top;
  }
  Vector3d operator()(const Torus& t) const {
    return beside_axis(t.radius, direction) + t.tube_radius * direction;
  }
  Vector3d operator()(const Capsule& c) const {
    return at_height(std::copysign(c.length / 2.0, direction.z())) + c.radius * direction;
  }
  Vector3d operator()(const Mesh& m) const {
    return *std::ranges::max_element(m.surface->vertices, {},
                                     [&](const Vector3d& vertex) { return direction.dot(vertex); });
  }

  Vector3d of_cylinder(double radius, double length) const {
    return beside_axis(radius, direction) + at_height(std::copysign(length / 2.0, direction.z()));
  }
};

/// The distance from a point to the far side of a shape.
struct FarSide {
  Vector3d from;

  double operator()(const Cylinder& c) const { return of_cylinder(c.radius, c.length); }
  double operator()(const Tube& t) const { return of_cylinder(t.radius, t.length); }
  double operator()(const Box& b) const { return (from.cwiseAbs() + b.size / 2.0).norm(); }
  double operator()(const Ellipsoid& e) const { return from.norm() + e.radii.maxCoeff(); }
  double operator()(const Cone& c) const {
    return std::max(std::hypot(across() + c.radius, from.z() + c.length / 2.0),
                    std::hypot(across() + c.top_radius, from.z() - c.length / 2.0));
  }
  double operator()(const Torus& t) const {
    return std::hypot(across() + t.radius, from.z()) + t.tube_radius;
  }
  double operator()(const Capsule& c) const {
    return std::hypot(across(), std::abs(from.z()) + c.length / 2.0) + c.radius;
  }
  double operator()(const Mesh& m) const {
    double squared = 0.0;
    for (const Vector3d& vertex : m.surface->vertices) {
      squared = std::max(squared, (vertex - from).squaredNorm());
    }
    return std::sqrt(squared);
  }

  double across() const { return std::hypot(from.x(), from.y()); }
  double of_cylinder(double radius, double length) const {
    return std::hypot(across() + radius, std::abs(from.z()) + length / 2.0);
  }
};

}  // namespace

double bounding_radius(const Shape& shape, const Vector3d& centre) {
  return std::visit(FarSide{centre}, shape);
}

Vector3d support(const Shape& shape, const Vector3d& direction) {
  return std::visit(Support{direction.stableNormalized()}, shape);
}

Eigen::AlignedBox3d bounding_box(const Shape& shape) {
  Eigen::AlignedBox3d box;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) box.extend(support(shape, side * Vector3d::Unit(axis)));
  }
  return box;
}

}  // namespace twrench::body
