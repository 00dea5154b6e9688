#include "body/shape_functions.h"
#include "body/shapes/geometry.h"

namespace twrench::body::shapes {

using Eigen::Vector3d;

std::string name(const Box&) { return "box"; }

std::vector<Dimension> dimensions(Box& b) { return {lengths("size", b.size)}; }

void check(const Box& b) { require_dimensions(b); }

double volume(const Box& b) { return b.size.prod(); }

Vector3d centroid(const Box&) { return Vector3d::Zero(); }

Eigen::Matrix3d central_inertia(const Box& b, double mass) {
  return inertia_of(mass, b.size.cwiseProduct(b.size) / 12.0);
}

Vector3d support(const Box& b, const Vector3d& direction) {
  return (b.size.array() / 2.0 * direction.array().sign()).matrix();
}

double far_side(const Box& b, const Vector3d& from) {
  return (from.cwiseAbs() + b.size / 2.0).norm();
}

}  // namespace twrench::body::shapes
