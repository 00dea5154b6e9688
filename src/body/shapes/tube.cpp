#include <cmath>
#include <numbers>

#include "body/shape_functions.h"
#include "body/shapes/geometry.h"

namespace twrench::body::shapes {

using Eigen::Vector3d;

std::string name(const Tube&) { return "tube"; }

std::vector<Dimension> dimensions(Tube& t) {
  return {length("radius", t.radius),
          smaller_length("inner_radius", t.inner_radius, "radius", t.radius),
          length("length", t.length)};
}

void check(const Tube& t) { require_dimensions(t); }

double volume(const Tube& t) {
  return std::numbers::pi * (t.radius - t.inner_radius) * (t.radius + t.inner_radius) * t.length;
}

Vector3d centroid(const Tube&) { return Vector3d::Zero(); }

Eigen::Matrix3d central_inertia(const Tube& t, double mass) {
  const double rr = (t.radius * t.radius + t.inner_radius * t.inner_radius) / 4.0;
  return inertia_of(mass, {rr, rr, t.length * t.length / 12.0});
}

Vector3d support(const Tube& t, const Vector3d& direction) {
  return support(Cylinder{t.radius, t.length}, direction);
}

double far_side(const Tube& t, const Vector3d& from) {
  return far_side(Cylinder{t.radius, t.length}, from);
}

}  // namespace twrench::body::shapes
