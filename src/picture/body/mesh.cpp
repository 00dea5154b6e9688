#include "picture/body/mesh.h"

#include <Eigen/Core>

#include "picture/body/polygon.h"
#include "picture/body/triangle_surface.h"
#include "picture/shapes/shapes.h"
#include "picture/space/glm_from_eigen.h"

namespace twrench::picture {
namespace {

class MeshBuilder {
 public:
  explicit MeshBuilder(const body::Part& part) : part_(part) {}

  void add(const SurfacePoint& point) {
    mesh_.vertices.push_back(
        {glm_from_eigen((part_.position + part_.body_from_part * point.position).eval()),
         glm_from_eigen((part_.body_from_part * point.normal).eval())});
  }

  /// Omits degenerate triangles, which a box has at the poles of its corners.
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (same_place(a, b) || same_place(b, c) || same_place(c, a)) return;
    mesh_.indices.insert(mesh_.indices.end(), {a, b, c});
  }

  void fill_ring(std::uint32_t first, std::uint32_t count, bool clockwise) {
    fill_polygon(first, first + count - 1, clockwise,
                 [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) { triangle(a, b, c); });
  }

  /// Connects a ring of `count` vertices with the one above it.
  void join(std::uint32_t low, std::uint32_t high, std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t next = (i + 1) % count;
      triangle(low + i, low + next, high + next);
      triangle(low + i, high + next, high + i);
    }
  }

  /// The same for the side of a cylinder, which is added last.
  void join_side(std::uint32_t low, std::uint32_t high, std::uint32_t count, double bevel) {
    side_ = {low, high, count, mesh_.indices.size(), bevel};
    join(low, high, count);
  }

  Mesh finish() {
    mesh_.vertex_ends = {mesh_.vertices.size()};
    mesh_.part_ends = {mesh_.indices.size()};
    mesh_.sides = {side_};
    mesh_.clusters.resize(1);
    mesh_.is_colored = {0};
    return std::move(mesh_);
  }

 private:
  bool same_place(std::uint32_t a, std::uint32_t b) const {
    return mesh_.vertices[a].position == mesh_.vertices[b].position;
  }

  const body::Part& part_;
  Mesh mesh_;
  std::optional<CylinderSide> side_;
};

}  // namespace

Mesh surface_of_rings(const body::Part& part, const Rings& surface) {
  const auto& [rings, has_hole, side, bevel] = surface;
  const auto count = static_cast<std::uint32_t>(rings.front().size());
  const auto last_ring = static_cast<std::uint32_t>(rings.size() - 1) * count;
  MeshBuilder mesh(part);
  for (const auto& ring : rings) {
    for (const SurfacePoint& point : ring) mesh.add(point);
  }
  if (has_hole) {
    mesh.join(last_ring, 0, count);
  } else {
    mesh.fill_ring(last_ring, count, false);
    mesh.fill_ring(0, count, true);
  }
  for (std::uint32_t low = 0; low < last_ring; low += count) {
    if (low != side.value_or(rings.size()) * count) mesh.join(low, low + count, count);
  }
  if (side) {
    const auto low = static_cast<std::uint32_t>(*side) * count;
    mesh.join_side(low, low + count, count, bevel);
  }
  return mesh.finish();
}

namespace {

/// Appends a mesh of one part.
void append(Mesh& all, const Mesh& mesh) {
  const auto offset = static_cast<std::uint32_t>(all.vertices.size());
  const std::size_t begin = all.indices.size();
  all.vertices.insert(all.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
  if (!all.colors.empty() || !mesh.colors.empty()) {
    all.colors.resize(offset);
    all.colors.insert(all.colors.end(), mesh.colors.begin(), mesh.colors.end());
    all.colors.resize(all.vertices.size());
  }
  for (const std::uint32_t index : mesh.indices) all.indices.push_back(offset + index);
  all.vertex_ends.push_back(all.vertices.size());
  all.part_ends.push_back(all.indices.size());
  all.sides.push_back(mesh.sides.front());
  if (auto& side = all.sides.back()) {
    side->low += offset;
    side->high += offset;
    side->begin += begin;
  }
  all.is_colored.push_back(mesh.is_colored.front());
  all.clusters.push_back(mesh.clusters.front());
  for (Cluster& cluster : all.clusters.back()) {
    cluster.begin += begin;
    cluster.end += begin;
  }
}

/// Converts a shape of any kind to its mesh.
struct PartMesher {
  const body::Part& part;
  double tolerance, crease_angle;

  Mesh operator()(const body::Mesh& mesh) const {
    return triangle_surface(mesh, part.position, part.body_from_part, tolerance, crease_angle);
  }
  Mesh operator()(const IsRings auto& solid) const {
    return surface_of_rings(part, rings_of(solid, tolerance));
  }
};

}  // namespace

Mesh part_mesh(const body::Part& part, double tolerance, double crease_angle) {
  return std::visit(PartMesher{part, tolerance, crease_angle}, part.shape);
}

Mesh body_mesh(std::span<const body::Part> parts, double tolerance,
               std::span<const scene::PartLook> looks) {
  Mesh result;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const scene::PartLook look = i < looks.size() ? looks[i] : scene::PartLook();
    append(result, part_mesh(parts[i], tolerance, look.crease_angle));
  }
  return result;
}

}  // namespace twrench::picture
