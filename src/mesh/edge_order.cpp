#include "mesh/edge_order.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace twrench::mesh {
namespace {

using Eigen::Vector3d;

/// Triangles closer than this lie on each other; rounding to single precision may have separated
/// them. What counts wrongly between them is less than the overlaps that are detected elsewhere.
constexpr double same_angle = 1e-5;

/// A half-plane that begins at the edge and contains a triangle.
struct HalfPlane {
  double angle;  ///< Radians about the edge, from the first triangle on.
  int step;      ///< Change of the winding number across it: 1 or -1.
};

/// Returns the part of a vector across a unit vector.
Vector3d across(const Vector3d& vector, const Vector3d& along) {
  return vector - vector.dot(along) * along;
}

}  // namespace

bool bounds_solid(const body::TriangleMesh& mesh, std::uint32_t from, std::uint32_t to,
                  std::span<const EdgeTriangle> triangles) {
  const Vector3d origin = mesh.vertices[from], edge = mesh.vertices[to] - origin;
  const Vector3d along = edge.normalized();
  const auto direction_of = [&](const EdgeTriangle& triangle) {
    return across(mesh.vertices[triangle.vertex] - origin, along);
  };
  const Vector3d first = direction_of(triangles.front()).normalized(), second = along.cross(first);
  std::vector<HalfPlane> planes;
  for (const EdgeTriangle& triangle : triangles) {
    const Vector3d direction = direction_of(triangle);
    // The height of a triangle without area is only round-off.
    const double size = (mesh.vertices[triangle.vertex] - origin).norm() + edge.norm();
    if (!(direction.norm() > 1e-12 * size)) return false;
    double angle = std::atan2(direction.dot(second), direction.dot(first));
    if (angle < -same_angle) angle += 2.0 * std::numbers::pi;
    planes.push_back({angle, triangle.is_forward ? 1 : -1});
  }
  std::ranges::sort(planes, {}, &HalfPlane::angle);
  int winding = 0, least = 0, greatest = 0;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    winding += planes[i].step;
    const bool is_last =
        i + 1 == planes.size() || planes[i + 1].angle - planes[i].angle > same_angle;
    if (!is_last) continue;
    least = std::min(least, winding);
    greatest = std::max(greatest, winding);
  }
  return greatest - least <= 1;
}

}  // namespace twrench::mesh
