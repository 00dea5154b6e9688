#include "render/mesh.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/glm_from_eigen.h"

namespace twrench {
namespace {

using Eigen::Vector3d;

constexpr int around = 192;         // facets of a full turn; a multiple of 4
constexpr int along_meridian = 96;  // facets of an ellipsoid from pole to pole; even
constexpr int along_bevel = 6;      // facets of a bevel's quarter turn
constexpr double bevel_share = 0.05;

struct Point {
  Vector3d position;
  Vector3d normal;
};

/// A closed surface as rings of equally many points, from its bottom (-z) to its top, each ring
/// counter-clockwise seen from the top; between them quads, and at both ends a fan.
struct Rings {
  Point bottom;
  std::vector<std::vector<Point>> rings;
  Point top;
};

Vector3d on_unit_sphere(double longitude, double latitude) {
  return {std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
          std::sin(latitude)};
}

/// The angles from `first` to `last`, both ends included.
std::vector<double> steps(double first, double last, int count) {
  std::vector<double> result;
  for (int i = 0; i <= count; ++i) result.push_back(first + (last - first) * i / count);
  return result;
}

constexpr double quarter = std::numbers::pi / 2;

Rings rings_of(const Cylinder& cylinder) {
  const double bevel = bevel_share * std::min(cylinder.radius, cylinder.length / 2);
  const double inner_radius = cylinder.radius - bevel;
  const double inner_height = cylinder.length / 2 - bevel;
  Rings result{{{0, 0, -cylinder.length / 2}, -Vector3d::UnitZ()},
               {},
               {{0, 0, cylinder.length / 2}, Vector3d::UnitZ()}};
  for (const double end : {-1.0, 1.0}) {
    const double middle = end * quarter / 2;  // of the bevel's latitudes, which run upward
    for (const double latitude : steps(middle - quarter / 2, middle + quarter / 2, along_bevel)) {
      auto& ring = result.rings.emplace_back();
      for (int i = 0; i < around; ++i) {
        const double longitude = 4 * quarter * i / around;
        const Vector3d normal = on_unit_sphere(longitude, latitude);
        const Vector3d inner = inner_radius * on_unit_sphere(longitude, 0);
        ring.push_back({inner + Vector3d(0, 0, end * inner_height) + bevel * normal, normal});
      }
    }
  }
  return result;
}

/// A box with rounded edges is a sphere of the bevel's radius, cut into octants that are moved
/// apart to the corners of an inner box.
Rings rings_of(const Box& box) {
  const double bevel = bevel_share * box.size.minCoeff() / 2;
  const Vector3d inner = (box.size.array() / 2 - bevel).matrix();
  Rings result{{{0, 0, -box.size.z() / 2}, -Vector3d::UnitZ()},
               {},
               {{0, 0, box.size.z() / 2}, Vector3d::UnitZ()}};
  for (const double up : {-1.0, 1.0}) {
    const double middle = up * quarter / 2;
    for (const double latitude : steps(middle - quarter / 2, middle + quarter / 2, along_bevel)) {
      auto& ring = result.rings.emplace_back();
      for (int octant = 0; octant < 4; ++octant) {
        const Vector3d corner = on_unit_sphere((octant + 0.5) * quarter, 0);
        const Vector3d signs(std::copysign(1.0, corner.x()), std::copysign(1.0, corner.y()), up);
        for (const double longitude :
             steps(octant * quarter, (octant + 1) * quarter, along_bevel)) {
          const Vector3d normal = on_unit_sphere(longitude, latitude);
          ring.push_back({signs.cwiseProduct(inner) + bevel * normal, normal});
        }
      }
    }
  }
  return result;
}

Rings rings_of(const Ellipsoid& ellipsoid) {
  const auto point = [&](double longitude, double latitude) {
    const Vector3d unit = on_unit_sphere(longitude, latitude);
    return Point{unit.cwiseProduct(ellipsoid.radii),
                 unit.cwiseQuotient(ellipsoid.radii).normalized()};
  };
  Rings result{point(0, -quarter), {}, point(0, quarter)};
  for (int j = 1; j < along_meridian; ++j) {
    auto& ring = result.rings.emplace_back();
    const double latitude = quarter * (2.0 * j / along_meridian - 1);
    for (int i = 0; i < around; ++i) ring.push_back(point(4 * quarter * i / around, latitude));
  }
  return result;
}

class MeshBuilder {
 public:
  explicit MeshBuilder(const Part& part) : part_(part) {}

  std::uint32_t add(const Point& point) {
    mesh_.vertices.push_back(
        {glm_from_eigen((part_.position + part_.body_from_part * point.position).eval()),
         glm_from_eigen((part_.body_from_part * point.normal).eval())});
    return static_cast<std::uint32_t>(mesh_.vertices.size() - 1);
  }

  /// Triangles without area, as a box has at the poles of its corners, are left out.
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (same_place(a, b) || same_place(b, c) || same_place(c, a)) return;
    mesh_.indices.insert(mesh_.indices.end(), {a, b, c});
  }

  Mesh take() { return std::move(mesh_); }

 private:
  bool same_place(std::uint32_t a, std::uint32_t b) const {
    return mesh_.vertices[a].position == mesh_.vertices[b].position;
  }

  const Part& part_;
  Mesh mesh_;
};

}  // namespace

Mesh part_mesh(const Part& part) {
  const Rings surface = std::visit([](const auto& shape) { return rings_of(shape); }, part.shape);
  MeshBuilder mesh(part);
  const auto count = static_cast<std::uint32_t>(surface.rings.front().size());
  const auto ring_count = static_cast<std::uint32_t>(surface.rings.size());
  for (const auto& ring : surface.rings) {
    for (const Point& point : ring) mesh.add(point);
  }
  const std::uint32_t bottom = mesh.add(surface.bottom);
  const std::uint32_t top = mesh.add(surface.top);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t next = (i + 1) % count;
    mesh.triangle(bottom, next, i);
    for (std::uint32_t ring = 0; ring + 1 < ring_count; ++ring) {
      const std::uint32_t low = ring * count;
      const std::uint32_t high = low + count;
      mesh.triangle(low + i, low + next, high + next);
      mesh.triangle(low + i, high + next, high + i);
    }
    const std::uint32_t last = (ring_count - 1) * count;
    mesh.triangle(top, last + i, last + next);
  }
  return mesh.take();
}

Mesh body_mesh(std::span<const Part> parts) {
  Mesh result;
  for (const Part& part : parts) {
    const auto offset = static_cast<std::uint32_t>(result.vertices.size());
    const Mesh mesh = part_mesh(part);
    result.vertices.insert(result.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    for (const std::uint32_t index : mesh.indices) result.indices.push_back(offset + index);
  }
  return result;
}

}  // namespace twrench
