#include "interchange/surface.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "picture/body/mesh.h"
#include "picture/overlay/draw_list.h"

namespace twrench::interchange {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr std::uint32_t around = 32;  // facets of an arrow

void append(std::vector<float>& numbers, const Vector3d& v) {
  for (const double number : v) numbers.push_back(static_cast<float>(number));
}

/// Adds the surface that the line from one point (radius, height; cm) of an outline to the next
/// sweeps about the z axis; seen from the axis, the outline goes upwards.
void add_band(Surface& surface, const Vector2d& from, const Vector2d& to) {
  const auto first = static_cast<std::uint32_t>(surface.positions.size() / 3);
  const Vector2d normal = Vector2d(to.y() - from.y(), from.x() - to.x()).normalized();
  for (const Vector2d& point : {from, to}) {
    for (std::uint32_t i = 0; i < around; ++i) {
      const double angle = 2 * std::numbers::pi * i / around;
      const Vector2d out(std::cos(angle), std::sin(angle));
      append(surface.positions,
             metres_per_cm * Vector3d(point.x() * out.x(), point.x() * out.y(), point.y()));
      append(surface.normals, Vector3d(normal.x() * out.x(), normal.x() * out.y(), normal.y()));
    }
  }
  for (std::uint32_t i = 0; i < around; ++i) {
    const std::uint32_t low = first + i, next = first + (i + 1) % around;
    if (from.x() > 0) surface.indices.insert(surface.indices.end(), {low, next, next + around});
    if (to.x() > 0)
      surface.indices.insert(surface.indices.end(), {low, next + around, low + around});
  }
}

}  // namespace

Surface part_surface(const body::Part& part, double tolerance, double crease_angle) {
  const bool is_mesh = std::holds_alternative<body::Mesh>(part.shape);
  const picture::Mesh mesh = picture::part_mesh(part, is_mesh ? 0 : tolerance, crease_angle);
  Surface surface;
  for (const picture::Vertex& vertex : mesh.vertices) {
    const glm::vec3 &p = vertex.position, &n = vertex.normal;
    append(surface.positions, metres_per_cm * Vector3d(p.x, p.y, p.z));
    append(surface.normals, Vector3d(n.x, n.y, n.z).normalized());
  }
  for (const glm::vec3& c : mesh.colors) append(surface.colors, Vector3d(c.x, c.y, c.z));
  surface.indices = mesh.indices;
  return surface;
}

Surface arrow_surface(double length, double shaft) {
  const double scale = std::min(1.0, length / (picture::arrow_head_length * shaft));
  const double neck = length - scale * picture::arrow_head_length * shaft;
  const double head = scale * picture::arrow_head_radius * shaft;
  Surface surface;
  if (neck > 0) {
    add_band(surface, {0, 0}, {shaft, 0});
    add_band(surface, {shaft, 0}, {shaft, neck});
  }
  add_band(surface, {neck > 0 ? shaft : 0, neck}, {head, neck});
  add_band(surface, {head, neck}, {0, length});
  return surface;
}

}  // namespace twrench::interchange
