#include <cmath>
#include <numbers>

#include "body/shape_functions.h"
#include "body/shapes/geometry.h"

namespace twrench::body::shapes {

using Eigen::Vector3d;

std::string name(const Torus&) { return "torus"; }

std::vector<Dimension> dimensions(Torus& t) {
  return {length("radius", t.radius),
          smaller_length("tube_radius", t.tube_radius, "radius", t.radius)};
}

void check(const Torus& t) { require_dimensions(t); }

double volume(const Torus& t) {
  return 2.0 * std::numbers::pi * std::numbers::pi * t.radius * t.tube_radius * t.tube_radius;
}

Vector3d centroid(const Torus&) { return Vector3d::Zero(); }

Eigen::Matrix3d central_inertia(const Torus& t, double mass) {
  const double aa = t.tube_radius * t.tube_radius;
  const double rr = (t.radius * t.radius + 0.75 * aa) / 2.0;
  return inertia_of(mass, {rr, rr, aa / 4.0});
}

Vector3d support(const Torus& t, const Vector3d& direction) {
  return beside_axis(t.radius, direction) + t.tube_radius * direction;
}

double far_side(const Torus& t, const Vector3d& from) {
  return std::hypot(distance_from_axis(from) + t.radius, from.z()) + t.tube_radius;
}

}  // namespace twrench::body::shapes
