#include <cmath>
#include <numbers>

#include "body/shape_functions.h"
#include "body/shapes/geometry.h"

namespace twrench::body::shapes {

using Eigen::Vector3d;

std::string name(const Cylinder&) { return "cylinder"; }

std::vector<Dimension> dimensions(Cylinder& c) {
  return {length("radius", c.radius), length("length", c.length)};
}

void check(const Cylinder& c) { require_dimensions(c); }

double volume(const Cylinder& c) { return std::numbers::pi * c.radius * c.radius * c.length; }

Vector3d centroid(const Cylinder&) { return Vector3d::Zero(); }

Eigen::Matrix3d central_inertia(const Cylinder& c, double mass) {
  const double rr = c.radius * c.radius / 4.0;
  return inertia_of(mass, {rr, rr, c.length * c.length / 12.0});
}

Vector3d support(const Cylinder& c, const Vector3d& direction) {
  return beside_axis(c.radius, direction) + at_height(std::copysign(c.length / 2.0, direction.z()));
}

double far_side(const Cylinder& c, const Vector3d& from) {
  return std::hypot(distance_from_axis(from) + c.radius, std::abs(from.z()) + c.length / 2.0);
}

}  // namespace twrench::body::shapes
