#include <numbers>

#include "body/shape_functions.h"
#include "body/shapes/geometry.h"

namespace twrench::body::shapes {

using Eigen::Vector3d;

std::string name(const Ellipsoid&) { return "ellipsoid"; }

std::vector<Dimension> dimensions(Ellipsoid& e) { return {lengths("radii", e.radii)}; }

void check(const Ellipsoid& e) { require_dimensions(e); }

double volume(const Ellipsoid& e) { return 4.0 / 3.0 * std::numbers::pi * e.radii.prod(); }

Vector3d centroid(const Ellipsoid&) { return Vector3d::Zero(); }

Eigen::Matrix3d central_inertia(const Ellipsoid& e, double mass) {
  return inertia_of(mass, e.radii.cwiseProduct(e.radii) / 5.0);
}

Vector3d support(const Ellipsoid& e, const Vector3d& direction) {
  return e.radii.cwiseProduct(e.radii.cwiseProduct(direction).normalized());
}

double far_side(const Ellipsoid& e, const Vector3d& from) {
  return from.norm() + e.radii.maxCoeff();
}

}  // namespace twrench::body::shapes
