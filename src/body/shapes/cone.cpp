#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "body/shape_functions.h"
#include "body/shapes/geometry.h"

namespace twrench::body::shapes {

using Eigen::Vector3d;

std::string name(const Cone&) { return "cone"; }

std::vector<Dimension> dimensions(Cone& c) {
  return {length("radius", c.radius), length("length", c.length),
          length_or_zero("top_radius", c.top_radius)};
}

void check(const Cone& c) { require_dimensions(c); }

double volume(const Cone& c) {
  const auto [a, b] = std::pair(c.radius, c.top_radius);
  return std::numbers::pi / 3.0 * c.length * (a * a + a * b + b * b);
}

Vector3d centroid(const Cone& c) {
  const auto [a, b] = std::pair(c.radius, c.top_radius);
  return {0.0, 0.0, c.length / 4.0 * (b - a) * (b + a) / (a * a + a * b + b * b)};
}

Eigen::Matrix3d central_inertia(const Cone& c, double mass) {
  const auto [a, b] = std::pair(c.radius, c.top_radius);
  const double ends = a * a + a * b + b * b;
  // The integrals of r^4/4 and of z^2 r^2 along the axis over that of r^2.
  const double rr =
      3.0 / 20.0 * (a * a * a * a + a * a * a * b + a * a * b * b + a * b * b * b + b * b * b * b) /
      ends;
  const double along = (a * a + 3.0 * a * b + 6.0 * b * b) / (10.0 * ends);  // from the base
  const double mean = (a * a + 2.0 * a * b + 3.0 * b * b) / (4.0 * ends);
  return inertia_of(mass, {rr, rr, c.length * c.length * (along - mean * mean)});
}

Vector3d support(const Cone& c, const Vector3d& direction) {
  const Vector3d base = beside_axis(c.radius, direction) + at_height(-c.length / 2.0);
  const Vector3d top = beside_axis(c.top_radius, direction) + at_height(c.length / 2.0);
  return direction.dot(base) > direction.dot(top) ? base : top;
}

double far_side(const Cone& c, const Vector3d& from) {
  const double across = distance_from_axis(from);
  return std::max(std::hypot(across + c.radius, from.z() + c.length / 2.0),
                  std::hypot(across + c.top_radius, from.z() - c.length / 2.0));
}

}  // namespace twrench::body::shapes
