#include "render/reach.h"

#include <algorithm>
#include <cmath>

namespace twrench {
namespace {

/// The distance from the origin, which is `origin` in the shape's own frame, to the shape's far
/// side.
struct FarSide {
  Eigen::Vector3d origin;

  double operator()(const Cylinder& c) const {
    return std::hypot(std::hypot(origin.x(), origin.y()) + c.radius,
                      std::abs(origin.z()) + c.length / 2);
  }
  double operator()(const Box& b) const { return (origin.cwiseAbs() + b.size / 2).norm(); }
  double operator()(const Ellipsoid& e) const { return origin.norm() + e.radii.maxCoeff(); }
};

}  // namespace

double reach(std::span<const Part> parts) {
  double result = 0;
  for (const Part& part : parts) {
    const Eigen::Vector3d origin = -part.body_from_part.transpose() * part.position;
    result = std::max(result, std::visit(FarSide{origin}, part.shape));
  }
  return result;
}

}  // namespace twrench
