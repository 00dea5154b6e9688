#include "render/body/bounding_radius.h"

#include <algorithm>
#include <cmath>

namespace twrench::render {
namespace {

/// The distance from the origin, which is `origin` in the shape's own frame, to the shape's far
/// side.
struct FarSide {
  Eigen::Vector3d origin;

  double operator()(const body::Cylinder& c) const {
    return std::hypot(std::hypot(origin.x(), origin.y()) + c.radius,
                      std::abs(origin.z()) + c.length / 2);
  }
  double operator()(const body::Box& b) const { return (origin.cwiseAbs() + b.size / 2).norm(); }
  double operator()(const body::Ellipsoid& e) const { return origin.norm() + e.radii.maxCoeff(); }
  double operator()(const auto& shape) const {
    return origin.norm() + body::bounding_radius(shape);
  }
};

}  // namespace

double bounding_radius(std::span<const body::Part> parts) {
  double result = 0;
  for (const body::Part& part : parts) {
    const Eigen::Vector3d origin = -part.body_from_part.transpose() * part.position;
    result = std::max(result, std::visit(FarSide{origin}, part.shape));
  }
  return result;
}

}  // namespace twrench::render
