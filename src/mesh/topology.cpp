#include "mesh/topology.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "mesh/disjoint_sets.h"

namespace twrench::mesh {
namespace {

/// One triangle's side of an edge. Sides are grouped by the edge's lesser vertex.
struct Side {
  std::uint32_t greater;  ///< The edge's greater vertex.
  /// Twice the triangle's index, plus 1 if it runs from the greater vertex to the lesser one.
  std::uint32_t triangle_and_direction;

  std::uint32_t triangle() const { return triangle_and_direction / 2; }
  bool is_backward() const { return triangle_and_direction % 2 != 0; }
};

/// The sides of all edges, grouped by lesser vertex.
struct Sides {
  std::vector<Side> sides;
  std::vector<std::uint32_t> end;  ///< Index past the last side of each vertex.
};

void for_each_side(const body::TriangleMesh& mesh, auto&& use) {
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    for (const auto& [from, to] : {DirectedEdge{a, b}, {b, c}, {c, a}}) {
      const bool backward = to < from;
      use(backward ? to : from, Side{backward ? from : to, 2 * i + (backward ? 1U : 0U)});
    }
  }
}

/// Sorts the sides by lesser vertex with a counting sort.
Sides sorted_sides(const body::TriangleMesh& mesh) {
  Sides sorted{std::vector<Side>(3 * mesh.triangles.size()),
               std::vector<std::uint32_t>(mesh.vertices.size() + 1)};
  for_each_side(mesh, [&](std::uint32_t lesser, const Side&) { ++sorted.end[lesser + 1]; });
  for (std::size_t i = 1; i < sorted.end.size(); ++i) sorted.end[i] += sorted.end[i - 1];
  // end[v] is the index at which the sides of v begin. Filling moves it past their end.
  for_each_side(mesh, [&](std::uint32_t lesser, const Side& side) {
    sorted.sides[sorted.end[lesser]++] = side;
  });
  sorted.end.pop_back();
  return sorted;
}

class EdgeReader {
 public:
  explicit EdgeReader(const body::TriangleMesh& mesh)
      : mesh_(&mesh), sets_(mesh.triangles.size()) {}

  /// Adds the triangles at an edge.
  void add(std::uint32_t lesser, std::span<const Side> sides) {
    const auto backward =
        static_cast<std::size_t>(std::ranges::count_if(sides, &Side::is_backward));
    for (const Side& side : sides.subspan(1)) {
      sets_.join(sides[0].triangle(), side.triangle());
    }
    if (2 * backward != sides.size()) ++found_.unbalanced;
    if (sides.size() == 2 && backward == 1) return;
    DirectedEdge edge{lesser, sides[0].greater};
    if (sides[0].is_backward()) std::swap(edge[0], edge[1]);
    if (sides.size() == 1) found_.open.push_back(edge);
    if (sides.size() == 2) found_.opposed.push_back(edge);
    if (sides.size() <= 2) return;
    if (2 * backward != sides.size())
      found_.branching.push_back(edge);
    else if (!is_solid_at(lesser, sides))
      found_.overlapping.push_back(edge);
  }

  /// Numbers the components and returns the topology.
  Topology finish() {
    found_.component.resize(sets_.size());
    for (std::uint32_t i = 0; i < sets_.size(); ++i) {
      const std::uint32_t first = sets_.find(i);
      found_.component[i] =
          first == i ? static_cast<std::uint32_t>(found_.components++) : found_.component[first];
    }
    return std::move(found_);
  }

 private:
  bool is_solid_at(std::uint32_t lesser, std::span<const Side> sides) const {
    const std::uint32_t greater = sides[0].greater;
    std::vector<EdgeTriangle> triangles;
    for (const Side& side : sides) {
      const auto& [a, b, c] = mesh_->triangles[side.triangle()];
      const std::uint32_t third = a ^ b ^ c ^ lesser ^ greater;  // the other two cancel out
      triangles.push_back({third, !side.is_backward()});
    }
    return bounds_solid(*mesh_, lesser, greater, triangles);
  }

  const body::TriangleMesh* mesh_;
  DisjointSets sets_;
  Topology found_;
};

}  // namespace

Topology topology(const body::TriangleMesh& mesh) {
  Sides sorted = sorted_sides(mesh);
  EdgeReader reader(mesh);
  std::uint32_t begin = 0;
  for (std::uint32_t lesser = 0; lesser < sorted.end.size(); ++lesser) {
    const std::span<Side> sides(&sorted.sides[0] + begin, sorted.end[lesser] - begin);
    std::ranges::sort(sides, {}, [](const Side& side) {
      return std::pair(side.greater, side.triangle_and_direction);
    });
    for (auto at = sides.begin(); at != sides.end();) {
      const auto next = std::ranges::find_if(
          at, sides.end(), [&](const Side& side) { return side.greater != at->greater; });
      reader.add(lesser, {at, next});
      at = next;
    }
    begin = sorted.end[lesser];
  }
  return reader.finish();
}

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
