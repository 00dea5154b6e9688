#include "picture/overlay/trail_point.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "picture/shapes/shapes.h"

namespace twrench::picture {
namespace {

using Eigen::Vector3d;

/// Returns the ends of a shape in its own frame, along lines through its centre of mass.
std::vector<Vector3d> ends_of(const body::Shape& shape) {
  const auto directions = traits_of(shape).ends;
  const Vector3d centre = body::centroid(shape);
  std::vector<Vector3d> ends;
  for (const auto& axis : directions.colwise()) {
    for (const double side : {1.0, -1.0}) {
      const Vector3d out = side * axis;
      ends.emplace_back(centre + out.dot(body::support(shape, out) - centre) * out);
    }
  }
  return ends;
}

std::vector<Vector3d> ends_of(const std::vector<body::Part>& parts) {
  std::vector<Vector3d> ends;
  for (const body::Part& part : parts) {
    for (const Vector3d& end : ends_of(part.shape)) {
      ends.emplace_back(part.position + part.body_from_part * end);
    }
  }
  return ends;
}

}  // namespace

Vector3d trail_point(const scene::Scene& scene) {
  if (scene.overlay.trail_point) {
    return *scene.overlay.trail_point - scene::mass_properties(scene.body).centre_of_mass;
  }
  // The trail lies on a sphere about the centre of mass, with room for the rim of an end that is up
  // to a third as wide as it is far away. A nearer trail would dive into the end's face.
  constexpr double same = 1e-6, outside = 1.06;
  std::vector<Vector3d> ends = ends_of(scene::visible_parts(scene.body));
  std::ranges::stable_sort(ends, std::greater<>(), [](const Vector3d& v) { return v.norm(); });
  const auto alone = [&](std::size_t i) {
    const auto near = [&](std::size_t k) {
      return std::abs(ends[k].norm() - ends[i].norm()) < same * ends[i].norm();
    };
    return !(i > 0 && near(i - 1)) && !(i + 1 < ends.size() && near(i + 1));
  };
  std::size_t chosen = 0;
  while (chosen < ends.size() && !alone(chosen)) ++chosen;
  return outside * ends[chosen < ends.size() ? chosen : 0];
}

}  // namespace twrench::picture
