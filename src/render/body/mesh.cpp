#include "render/body/mesh.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/body/polygon.h"
#include "render/space/glm_from_eigen.h"

namespace twrench::render {
namespace {

using Eigen::Vector3d;

// Shares of half the smallest dimension.
constexpr double rim_share = 0.04, edge_share = 0.08, widest_bevel_share = 0.12;
constexpr double least_bevel = 12;  // in tolerances
constexpr double quarter = std::numbers::pi / 2;

// Minimum number of chords per quarter turn, however small the picture: normals are interpolated
// linearly.
constexpr int least_of_body = 8;
constexpr int least_of_bevel = 2;

/// Returns how many chords a quarter of a circle of `radius` needs to stay within `tolerance` of
/// it.
int chords_of_quarter(double radius, double tolerance, int least) {
  if (tolerance >= radius) return least;
  const double half_angle = std::acos(1 - tolerance / radius);
  return std::max(least, static_cast<int>(std::ceil(quarter / (2 * half_angle))));
}

double bevel_of(double half, double share, double tolerance) {
  return std::max(share * half, std::min(least_bevel * tolerance, widest_bevel_share * half));
}

struct SurfacePoint {
  Vector3d position;
  Vector3d normal;
};

/// A closed surface as rings with the same number of points, from its bottom (-z) to its top, each
/// ring counter-clockwise as seen from the top. Quads connect them; the first and the last ring are
/// filled.
using Rings = std::vector<std::vector<SurfacePoint>>;

Vector3d on_unit_sphere(double longitude, double latitude) {
  return {std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
          std::sin(latitude)};
}

/// The angles from `first` to `last`, both included.
std::vector<double> evenly_spaced(double first, double last, int count) {
  std::vector<double> result;
  for (int i = 0; i <= count; ++i) result.push_back(first + (last - first) * i / count);
  return result;
}

/// The latitudes of the bevel at the end -1 or +1 of a shape, upwards.
std::vector<double> bevel_latitudes(double end, int chords) {
  return end < 0 ? evenly_spaced(-quarter, 0, chords) : evenly_spaced(0, quarter, chords);
}

double rim_bevel(const body::Cylinder& cylinder, double tolerance) {
  return bevel_of(std::min(cylinder.radius, cylinder.length / 2), rim_share, tolerance);
}

Rings rings_of(const body::Cylinder& cylinder, double tolerance) {
  const double bevel = rim_bevel(cylinder, tolerance);
  const double inner_radius = cylinder.radius - bevel;
  const double inner_height = cylinder.length / 2 - bevel;
  const int around = 4 * chords_of_quarter(cylinder.radius, tolerance, least_of_body);
  const int along_bevel = chords_of_quarter(bevel, tolerance, least_of_bevel);
  Rings rings;
  for (const double end : {-1.0, 1.0}) {
    for (const double latitude : bevel_latitudes(end, along_bevel)) {
      auto& ring = rings.emplace_back();
      for (int i = 0; i < around; ++i) {
        const double longitude = 4 * quarter * i / around;
        const Vector3d normal = on_unit_sphere(longitude, latitude);
        const Vector3d inner = inner_radius * on_unit_sphere(longitude, 0);
        ring.push_back({inner + Vector3d(0, 0, end * inner_height) + bevel * normal, normal});
      }
    }
  }
  return rings;
}

/// A box with rounded edges is a sphere of the bevel's radius, cut into octants that are moved
/// apart to the corners of an inner box.
Rings rings_of(const body::Box& box, double tolerance) {
  const double bevel = bevel_of(box.size.minCoeff() / 2, edge_share, tolerance);
  const Vector3d inner = (box.size.array() / 2 - bevel).matrix();
  const int chords = chords_of_quarter(bevel, tolerance, least_of_bevel);
  Rings rings;
  for (const double end : {-1.0, 1.0}) {
    for (const double latitude : bevel_latitudes(end, chords)) {
      auto& ring = rings.emplace_back();
      for (int octant = 0; octant < 4; ++octant) {
        const Vector3d middle = on_unit_sphere((octant + 0.5) * quarter, 0);
        const Vector3d corner(std::copysign(inner.x(), middle.x()),
                              std::copysign(inner.y(), middle.y()), end * inner.z());
        for (const double longitude :
             evenly_spaced(octant * quarter, (octant + 1) * quarter, chords)) {
          const Vector3d normal = on_unit_sphere(longitude, latitude);
          ring.push_back({corner + bevel * normal, normal});
        }
      }
    }
  }
  return rings;
}

Rings rings_of(const body::Ellipsoid& ellipsoid, double tolerance) {
  const int chords = chords_of_quarter(ellipsoid.radii.maxCoeff(), tolerance, least_of_body);
  Rings rings;
  for (int j = 0; j < 2 * chords; ++j) {
    auto& ring = rings.emplace_back();
    const double latitude = quarter * ((j + 0.5) / chords - 1);  // half a step from the poles
    for (int i = 0; i < 4 * chords; ++i) {
      const Vector3d unit = on_unit_sphere(quarter * i / chords, latitude);
      ring.push_back(
          {unit.cwiseProduct(ellipsoid.radii), unit.cwiseQuotient(ellipsoid.radii).normalized()});
    }
  }
  return rings;
}

Rings rings_of(const auto& shape, double tolerance) {
  return rings_of(body::Ellipsoid{Vector3d::Constant(body::bounding_radius(shape))}, tolerance);
}

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

Mesh part_mesh(const body::Part& part, double tolerance) {
  const Rings rings =
      std::visit([&](const auto& shape) { return rings_of(shape, tolerance); }, part.shape);
  const auto count = static_cast<std::uint32_t>(rings.front().size());
  const auto last_ring = static_cast<std::uint32_t>(rings.size() - 1) * count;
  MeshBuilder mesh(part);
  for (const auto& ring : rings) {
    for (const SurfacePoint& point : ring) mesh.add(point);
  }
  mesh.fill_ring(last_ring, count, false);
  mesh.fill_ring(0, count, true);
  const auto* const cylinder = std::get_if<body::Cylinder>(&part.shape);
  const std::uint32_t side = cylinder != nullptr ? (last_ring - count) / 2 : last_ring;
  for (std::uint32_t low = 0; low < last_ring; low += count) {
    if (low != side) mesh.join(low, low + count, count);
  }
  if (cylinder != nullptr) {
    mesh.join_side(side, side + count, count, rim_bevel(*cylinder, tolerance));
  }
  return mesh.finish();
}

Mesh body_mesh(std::span<const body::Part> parts, double tolerance) {
  Mesh result;
  for (const body::Part& part : parts) {
    const auto offset = static_cast<std::uint32_t>(result.vertices.size());
    const Mesh mesh = part_mesh(part, tolerance);
    result.vertices.insert(result.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    for (const std::uint32_t index : mesh.indices) result.indices.push_back(offset + index);
    result.vertex_ends.push_back(result.vertices.size());
    result.part_ends.push_back(result.indices.size());
    result.sides.push_back(mesh.sides.front());
    if (auto& side = result.sides.back()) {
      side->low += offset;
      side->high += offset;
      side->begin += result.indices.size() - mesh.indices.size();
    }
  }
  return result;
}

}  // namespace twrench::render
