#include "mesh/polygon.h"

#include <Eigen/Core>
#include <algorithm>

#include "mesh/ear_clipping.h"

namespace twrench::mesh {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Triangle = std::array<std::uint32_t, 3>;

std::vector<std::uint32_t> ring_of(std::span<const Triangle> fan) {
  std::vector<std::uint32_t> ring{fan[0][0], fan[0][1]};
  for (const Triangle& triangle : fan) ring.push_back(triangle[2]);
  return ring;
}

/// Returns the counter-clockwise projection of the polygon onto the coordinate plane in which it is
/// largest. It serves as well as the polygon's own plane and involves no rounding.
std::vector<Vector2d> projected(std::span<const std::uint32_t> ring,
                                const std::vector<Vector3d>& vertices) {
  std::vector<Vector3d> points;
  points.reserve(ring.size());
  for (const std::uint32_t corner : ring) points.emplace_back(vertices[corner] - vertices[ring[0]]);
  Vector3d normal = Vector3d::Zero();
  for (std::size_t i = 1; i + 1 < points.size(); ++i) normal += points[i].cross(points[i + 1]);
  Eigen::Index axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  Eigen::Index across = (axis + 1) % 3, up = (axis + 2) % 3;
  if (normal[axis] < 0.0) std::swap(across, up);
  std::vector<Vector2d> polygon;
  polygon.reserve(points.size());
  for (const Vector3d& point : points) polygon.emplace_back(point[across], point[up]);
  return polygon;
}

/// Returns whether no triangle of the fan is turned over or without area. The fan then covers the
/// polygon exactly once.
bool is_fan_inside(std::span<const Vector2d> polygon) {
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    if (turn(polygon[0], polygon[i], polygon[i + 1]) != Turn::left) return false;
  }
  return true;
}

}  // namespace

void Polygons::add(std::span<const std::uint32_t> ring, body::TriangleMesh& mesh) {
  if (ring.size() > 3) fans_.push_back({mesh.triangles.size(), ring.size() - 2});
  for (std::size_t k = 1; k + 1 < ring.size(); ++k) {
    mesh.triangles.push_back({ring[0], ring[k], ring[k + 1]});
  }
}

void Polygons::triangulate(body::TriangleMesh& mesh) const {
  Allowance allowance(usual_steps);
  for (const auto& [first, count] : fans_) {
    const std::span triangles(mesh.triangles.data() + first, count);
    const std::vector<std::uint32_t> ring = ring_of(triangles);
    const std::vector<Vector2d> polygon = projected(ring, mesh.vertices);
    // Differences of coordinates may overflow.
    const auto is_finite = [](const Vector2d& point) { return point.allFinite(); };
    if (!std::ranges::all_of(polygon, is_finite) || is_fan_inside(polygon)) continue;
    if (const auto ears = clip_ears(polygon, allowance)) {
      std::ranges::transform(*ears, triangles.begin(), [&](const Triangle& ear) {
        return Triangle{ring[ear[0]], ring[ear[1]], ring[ear[2]]};
      });
    }
  }
}

}  // namespace twrench::mesh
