#include "picture/body/hollows.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <deque>
#include <functional>
#include <glm/common.hpp>
#include <limits>
#include <mutex>
#include <numbers>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/parallel.h"
#include "mesh/triangle_tree.h"

namespace twrench::picture {
namespace {

using Eigen::Array4f;
using Eigen::Vector3f;

// The same directions at all vertices: the error then varies as smoothly as the surface, whereas
// random directions would mottle it.
constexpr std::size_t most_directions = 192;  // over the whole sphere
constexpr std::size_t least_directions = 48;
constexpr std::size_t most_rays = 6'000'000;
constexpr float least_cosine = 0.05F;  // grazing rays would meet the facets of a round surface
constexpr float usual_albedo = 0.6F;   // of a part without vertex colours

/// Directions spread evenly over the sphere (spherical Fibonacci lattice).
std::vector<Vector3f> directions_around(std::size_t count) {
  std::vector<Vector3f> result;
  for (std::size_t i = 0; i < count; ++i) {
    const double z = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(count);
    const double angle = 2 * std::numbers::pi * std::numbers::phi * static_cast<double>(i);
    const double r = std::sqrt(1 - z * z);
    result.emplace_back(Eigen::Vector3d(r * std::cos(angle), r * std::sin(angle), z).cast<float>());
  }
  return result;
}

/// Coordinates of four points or directions, which one instruction can compute with.
using FourVectors = std::array<Array4f, 3>;

Array4f dot(const FourVectors& a, const Vector3f& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Array4f dot(const FourVectors& a, const FourVectors& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// A ray in the coordinates of a tree's boxes.
struct Ray {
  Vector3f origin, direction, inverse;

  Ray(const Vector3f& from, const Vector3f& along)
      : origin(from), direction(along), inverse(along.cwiseInverse()) {}
};

/// Four boxes. One that is not set meets no ray.
struct FourBoxes {
  FourVectors min, max;

  FourBoxes() {
    min.fill(Array4f::Constant(std::numeric_limits<float>::max()));
    max = min;
  }

  void set(Eigen::Index i, const Eigen::AlignedBox3f& box) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      min.at(axis)[i] = box.min()[static_cast<Eigen::Index>(axis)];
      max.at(axis)[i] = box.max()[static_cast<Eigen::Index>(axis)];
    }
  }

  Eigen::Array<bool, 4, 1> meet(const Ray& ray) const {
    Array4f enter = Array4f::Zero(), leave = Array4f::Constant(std::numeric_limits<float>::max());
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<Eigen::Index>(axis);
      const Array4f a = (min[axis] - ray.origin[i]) * ray.inverse[i];
      const Array4f b = (max[axis] - ray.origin[i]) * ray.inverse[i];
      enter = enter.max(a.min(b));
      leave = leave.min(a.max(b));
    }
    return enter <= leave;
  }
};

/// Four triangles, each a corner and the two sides that begin there. One that is not set is a
/// point.
struct FourTriangles {
  FourVectors corner, one, other;

  FourTriangles() {
    corner.fill(Array4f::Zero());
    one = other = corner;
  }

  void set(Eigen::Index i, const std::array<Vector3f, 3>& corners) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto k = static_cast<Eigen::Index>(axis);
      corner.at(axis)[i] = corners[0][k];
      one.at(axis)[i] = corners[1][k] - corners[0][k];
      other.at(axis)[i] = corners[2][k] - corners[0][k];
    }
  }

  /// Whether the ray meets an outer face (Möller and Trumbore, "Fast, Minimum Storage Ray-Triangle
  /// Intersection", Journal of Graphics Tools 2 (1997)).
  bool block(const Ray& ray) const {
    const Vector3f& d = ray.direction;
    const FourVectors p{d[1] * other[2] - d[2] * other[1], d[2] * other[0] - d[0] * other[2],
                        d[0] * other[1] - d[1] * other[0]};
    const Array4f det = dot(one, p);  // negative for the inner face
    const FourVectors from{ray.origin[0] - corner[0], ray.origin[1] - corner[1],
                           ray.origin[2] - corner[2]};
    const Array4f u = dot(from, p);
    const FourVectors q{from[1] * one[2] - from[2] * one[1], from[2] * one[0] - from[0] * one[2],
                        from[0] * one[1] - from[1] * one[0]};
    const Array4f v = dot(q, d);
    return (det > 0 && u >= 0 && u <= det && v >= 0 && u + v <= det && dot(other, q) > 0).any();
  }
};

/// Vertices and indices of a part.
struct Range {
  std::size_t first_vertex, vertices_end, begin, end;
};

Range range_of(const Mesh& mesh, std::size_t part) {
  return {part == 0 ? 0 : mesh.vertex_ends[part - 1], mesh.vertex_ends[part],
          part == 0 ? 0 : mesh.part_ends[part - 1], mesh.part_ends[part]};
}

body::TriangleMesh triangles_of(const Mesh& mesh, const Range& part) {
  body::TriangleMesh result;
  for (std::size_t i = part.first_vertex; i < part.vertices_end; ++i) {
    const glm::dvec3 place(mesh.vertices[i].position);
    result.vertices.emplace_back(place.x, place.y, place.z);
  }
  const auto corner = [&](std::size_t i) {
    return static_cast<std::uint32_t>(mesh.indices[i] - part.first_vertex);
  };
  for (std::size_t i = part.begin; i < part.end; i += 3) {
    result.triangles.push_back({corner(i), corner(i + 1), corner(i + 2)});
  }
  return result;
}

/// The triangles that keep light away.
class Blockers {
 public:
  explicit Blockers(const body::TriangleMesh& mesh) {
    const mesh::TriangleTree tree(mesh);
    origin_ = tree.whole().min();
    size_ = tree.box(1).sizes().norm();
    first_leaf_ = tree.first_leaf();
    first_ = std::countr_zero(first_leaf_) % 2 == 0 ? 1 : 2;
    const auto set = [&](FourBoxes& boxes, Eigen::Index i, std::size_t node) {
      if (!tree.box(node).isEmpty()) boxes.set(i, tree.box(node));
    };
    grandchildren_.resize(first_leaf_ / 2);
    for (std::size_t node = 1; node < first_leaf_ / 2; ++node) {
      for (Eigen::Index i = 0; i < 4; ++i)
        set(grandchildren_[node], i, 4 * node + static_cast<std::size_t>(i));
    }
    leaves_.resize(first_leaf_);
    for (std::size_t i = 0; i < first_leaf_; ++i) {
      Eigen::Index k = 0;
      for (const mesh::TriangleTree::Item& item : tree.items(first_leaf_ + i)) {
        leaves_[i].set(k++,
                       {local(tree.corner(item.triangle, 0)), local(tree.corner(item.triangle, 1)),
                        local(tree.corner(item.triangle, 2))});
      }
    }
  }

  /// A place in the coordinates of rays.
  Vector3f local(const Eigen::Vector3d& place) const { return (place - origin_).cast<float>(); }

  float size() const { return size_; }

  bool block(const Ray& ray) const {
    std::array<std::size_t, 64> waiting;  // the tree's depth is at most 31
    std::size_t count = 0;
    for (std::size_t node = first_; node < 2 * first_; ++node) waiting.at(count++) = node;
    while (count > 0) {
      const std::size_t node = waiting.at(--count);
      if (node >= first_leaf_) {
        if (leaves_[node - first_leaf_].block(ray)) return true;
        continue;
      }
      const auto met = grandchildren_[node].meet(ray);
      for (std::size_t i = 0; i < 4; ++i) {
        if (met[static_cast<Eigen::Index>(i)]) waiting.at(count++) = 4 * node + i;
      }
    }
    return false;
  }

 private:
  Eigen::Vector3d origin_;
  float size_;
  std::size_t first_leaf_;
  /// The first node of the levels that are visited: every other one, and that of the leaves.
  std::size_t first_;
  std::vector<FourBoxes> grandchildren_;  ///< The boxes of each node's grandchildren.
  std::vector<FourTriangles> leaves_;
};

/// Returns for each vertex a place close to it on its triangles. In a crease the vertex itself lies
/// in the planes of the triangles beyond, which would block nothing.
std::vector<Eigen::Vector3d> places_of(const body::TriangleMesh& mesh) {
  constexpr double share = 0.05;  // of the way to the middle of its triangles
  std::vector<Eigen::Vector3d> sums(mesh.vertices.size(), Eigen::Vector3d::Zero());
  std::vector<int> counts(mesh.vertices.size());
  for (const auto& corners : mesh.triangles) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const std::uint32_t corner : corners) middle += mesh.vertices[corner] / 3;
    for (const std::uint32_t corner : corners) {
      sums[corner] += middle - mesh.vertices[corner];
      ++counts[corner];
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    sums[i] = mesh.vertices[i] + share / std::max(counts[i], 1) * sums[i];
  }
  return sums;
}

/// Returns for each vertex of a part the fraction of the light from all directions above it that
/// the part does not block, weighted by the cosine to the normal.
std::vector<float> openness(const Mesh& mesh, const Range& part, std::size_t directions) {
  const body::TriangleMesh triangles = triangles_of(mesh, part);
  const Blockers part_blockers(triangles);
  const std::vector<Eigen::Vector3d> places = places_of(triangles);
  const std::vector<Vector3f> sphere = directions_around(directions);
  const float lift = 1e-4F * part_blockers.size();  // off the vertex's own triangles
  std::vector<float> result(triangles.vertices.size());
  constexpr std::size_t grain = 256;
  for_each_part(result.size(), grain, 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const glm::vec3& n = mesh.vertices[part.first_vertex + i].normal;
      const Vector3f normal(n.x, n.y, n.z);
      const Vector3f origin = part_blockers.local(places[i]) + lift * normal;
      float open = 0, all = 0;
      for (const Vector3f& direction : sphere) {
        const float cosine = normal.dot(direction);
        if (cosine < least_cosine) continue;
        all += cosine;
        if (!part_blockers.block({origin, direction})) open += cosine;
      }
      result[i] = open / all;
    }
  });
  return result;
}

/// Hash of the bytes of a range of numbers.
template <typename T>
std::size_t hash_of(std::span<const T> values) {
  static_assert(std::is_trivially_copyable_v<T>);
  const auto bytes = std::as_bytes(values);
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes are characters
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return std::hash<std::string_view>()(text);
}

/// The openness of the last parts, because the panes of a comparison and the shots of a film show
/// the same ones.
class RecentParts {
 public:
  std::vector<float> openness_of(const Mesh& mesh, const Range& part, std::size_t directions) {
    const Key key{directions,
                  hash_of(std::span(mesh.vertices)
                              .subspan(part.first_vertex, part.vertices_end - part.first_vertex)),
                  hash_of(std::span(mesh.indices).subspan(part.begin, part.end - part.begin))};
    const std::scoped_lock lock(mutex_);
    const auto found = std::ranges::find(parts_, key, &Part::key);
    if (found != parts_.end()) return found->openness;
    if (parts_.size() == most) parts_.pop_front();
    return parts_.emplace_back(Part{key, openness(mesh, part, directions)}).openness;
  }

 private:
  static constexpr std::size_t most = 16;
  using Key = std::array<std::size_t, 3>;
  struct Part {
    Key key;
    std::vector<float> openness;
  };

  std::mutex mutex_;  ///< Guards the parts.
  std::deque<Part> parts_;
};

/// The light that reaches a surface in a hollow of this colour.
glm::vec3 with_reflections(float open, const glm::vec3& color) {
  const glm::vec3 a = 2.0404F * color - 0.3324F;
  const glm::vec3 b = -4.7951F * color + 0.6417F;
  const glm::vec3 c = 2.7552F * color + 0.6903F;
  return glm::max(glm::vec3(open), ((open * a + b) * open + c) * open);
}

}  // namespace

void shade_hollows(Mesh& mesh) {
  std::size_t vertices = 0;
  for (std::size_t part = 0; part < mesh.part_ends.size(); ++part) {
    const Range range = range_of(mesh, part);
    if (!mesh.clusters[part].empty()) vertices += range.vertices_end - range.first_vertex;
  }
  if (vertices == 0) return;
  const std::size_t directions =
      std::clamp(2 * most_rays / vertices, least_directions, most_directions);
  static RecentParts recent_parts;
  mesh.colors.resize(mesh.vertices.size());
  for (std::size_t part = 0; part < mesh.part_ends.size(); ++part) {
    if (mesh.clusters[part].empty()) continue;
    const Range range = range_of(mesh, part);
    const std::vector<float> open = recent_parts.openness_of(mesh, range, directions);
    for (std::size_t i = 0; i < open.size(); ++i) {
      glm::vec3& color = mesh.colors[range.first_vertex + i];
      color = mesh.is_colored[part] == 0 ? with_reflections(open[i], glm::vec3(usual_albedo))
                                         : color * with_reflections(open[i], color);
    }
    mesh.is_colored[part] = 1;
  }
}

}  // namespace twrench::picture
