#include <cmath>
#include <numbers>

#include "body/shape_functions.h"
#include "body/shapes/geometry.h"

namespace twrench::body::shapes {

using Eigen::Vector3d;

std::string name(const Capsule&) { return "capsule"; }

std::vector<Dimension> dimensions(Capsule& c) {
  return {length("radius", c.radius), length("length", c.length)};
}

void check(const Capsule& c) { require_dimensions(c); }

double volume(const Capsule& c) {
  return std::numbers::pi * c.radius * c.radius * (c.length + 4.0 / 3.0 * c.radius);
}

Vector3d centroid(const Capsule&) { return Vector3d::Zero(); }

Eigen::Matrix3d central_inertia(const Capsule& c, double mass) {
  const double r = c.radius, h = c.length;
  const double middle = h / (h + 4.0 / 3.0 * r);  // its share of the volume
  const double rr = middle * r * r / 4.0 + (1.0 - middle) * r * r / 5.0;
  // A hemisphere's mean height above its base is 3r/8, and its mean square r^2/5.
  const double ends = h * h / 4.0 + 3.0 / 8.0 * h * r + r * r / 5.0;
  return inertia_of(mass, {rr, rr, middle * h * h / 12.0 + (1.0 - middle) * ends});
}

Vector3d support(const Capsule& c, const Vector3d& direction) {
  return at_height(std::copysign(c.length / 2.0, direction.z())) + c.radius * direction;
}

double far_side(const Capsule& c, const Vector3d& from) {
  return std::hypot(distance_from_axis(from), std::abs(from.z()) + c.length / 2.0) + c.radius;
}

}  // namespace twrench::body::shapes
