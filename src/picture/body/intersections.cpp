#include "picture/body/intersections.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <glm/geometric.hpp>
#include <optional>
#include <unsupported/Eigen/BVH>
#include <utility>

#include "picture/body/body_model.h"
#include "picture/space/glm_from_eigen.h"

namespace twrench::picture {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

using Number = std::uint32_t;  // of a triangle in the mesh
using TriangleTree = Eigen::KdBVH<double, 3, Number>;

Matrix3d corners_of(const Mesh& mesh, Number triangle) {
  Matrix3d corners;
  for (const Number k : {0U, 1U, 2U}) {
    const glm::vec3& place = mesh.vertices[mesh.indices[3 * triangle + k]].position;
    corners.col(k) << place.x, place.y, place.z;
  }
  return corners;
}

AlignedBox3d box_of(const Matrix3d& corners) {
  return {corners.rowwise().minCoeff(), corners.rowwise().maxCoeff()};
}

Vector3d normal_of(const Matrix3d& corners) {
  return (corners.col(1) - corners.col(0)).cross(corners.col(2) - corners.col(0));
}

/// Returns the two points in which the border of a triangle intersects the plane of another one,
/// which is moved inwards by `touch`; nothing if the whole border is on one side.
std::optional<std::array<Vector3d, 2>> passage(const Matrix3d& corners, const Matrix3d& plane,
                                               double touch) {
  const Vector3d normal = normal_of(plane).normalized();
  const Vector3d heights =
      ((corners.colwise() - plane.col(0)).transpose() * normal).array() + touch;
  std::array<Vector3d, 2> points;
  std::size_t found = 0;
  for (const Eigen::Index k : {0, 1, 2}) {
    const Eigen::Index next = (k + 1) % 3;
    if ((heights[k] < 0) == (heights[next] < 0)) continue;
    const double share = heights[k] / (heights[k] - heights[next]);
    points.at(found++) = corners.col(k) + share * (corners.col(next) - corners.col(k));
  }
  if (found == 0) return std::nullopt;
  return points;
}

/// Returns the segment that two triangles share (Möller, "A Fast Triangle-Triangle Intersection
/// Test", Journal of Graphics Tools 2 (1997)), in the direction of the cross product of their
/// normals; nothing if there is none.
std::optional<std::array<Vector3d, 2>> common_segment(const Matrix3d& one, const Matrix3d& other,
                                                      double touch) {
  auto first = passage(one, other, touch);
  if (!first) return std::nullopt;
  auto second = passage(other, one, touch);
  if (!second) return std::nullopt;
  const Vector3d along = normal_of(one).cross(normal_of(other));
  const auto is_before = [&](const Vector3d& a, const Vector3d& b) { return along.dot(b - a) > 0; };
  for (auto* const points : {&*first, &*second}) {
    if (!is_before(points->front(), points->back())) std::swap(points->front(), points->back());
  }
  const std::array segment{
      is_before(first->front(), second->front()) ? second->front() : first->front(),
      is_before(first->back(), second->back()) ? first->back() : second->back()};
  if (!is_before(segment[0], segment[1])) return std::nullopt;
  return segment;
}

/// A segment that a triangle shares with another one.
struct CommonSegment {
  Number other;
  std::array<Vector3d, 2> ends;
};

/// A tree query for the triangles that share a segment with a triangle of another part.
class TriangleQuery {
 public:
  TriangleQuery(const Mesh& mesh, Number triangle, double touch)
      : mesh_(mesh), corners_(corners_of(mesh, triangle)), box_(box_of(corners_)), touch_(touch) {}

  bool intersectVolume(const AlignedBox3d& volume) const { return volume.intersects(box_); }
  bool intersectObject(Number other) {
    const Matrix3d corners = corners_of(mesh_, other);
    if (const auto ends = common_segment(corners_, corners, touch_))
      found_.push_back({other, *ends});
    constexpr bool is_done = false;
    return is_done;
  }

  const std::vector<CommonSegment>& found() const { return found_; }

 private:
  const Mesh& mesh_;
  Matrix3d corners_;
  AlignedBox3d box_;
  double touch_;
  std::vector<CommonSegment> found_;
};

/// The barycentric coordinates of a point of a triangle.
Vector3d shares_at(const Matrix3d& corners, const Vector3d& point) {
  const Vector3d normal = normal_of(corners);
  const Vector3d at = point - corners.col(0);
  const double second = normal.dot(at.cross(corners.col(2) - corners.col(0)));
  const double third = normal.dot((corners.col(1) - corners.col(0)).cross(at));
  const double whole = normal.squaredNorm();
  return {1 - (second + third) / whole, second / whole, third / whole};
}

IntersectionEdge edge_of(const Mesh& mesh, Number triangle, Number other, const Vector3d& from,
                         const Vector3d& to) {
  IntersectionEdge edge{triangle, other, {}, {}};
  const Matrix3d corners = corners_of(mesh, triangle);
  for (const std::size_t end : {0, 1}) {
    const Vector3d& place = end == 0 ? from : to;
    const Vector3d shares = shares_at(corners, place);
    Vertex& vertex = edge.ends.at(end);
    vertex = {glm_from_eigen(place), glm::vec3(0)};
    for (const Number k : {0U, 1U, 2U}) {
      const auto share = static_cast<float>(shares[k]);
      const Number corner = mesh.indices[3 * triangle + k];
      vertex.normal += share * mesh.vertices[corner].normal;
      if (!mesh.colors.empty()) edge.colors.at(end) += share * mesh.colors[corner];
    }
  }
  return edge;
}

/// The triangles of a part, and the box around them.
struct PartTriangles {
  Number begin, end;
  AlignedBox3d box;
};

std::vector<PartTriangles> triangles_of_parts(const Mesh& mesh) {
  std::vector<PartTriangles> result;
  Number begin = 0;
  for (const std::size_t part_end : mesh.part_ends) {
    PartTriangles part{begin, static_cast<Number>(part_end / 3), {}};
    for (Number i = part.begin; i < part.end; ++i) part.box.extend(box_of(corners_of(mesh, i)));
    result.push_back(part);
    begin = part.end;
  }
  return result;
}

/// Returns the triangles of a part whose boxes intersect the box of another part, and these boxes.
std::pair<std::vector<Number>, std::vector<AlignedBox3d>> triangles_near(
    const Mesh& mesh, const PartTriangles& part, const AlignedBox3d& other) {
  std::pair<std::vector<Number>, std::vector<AlignedBox3d>> result;
  for (Number i = part.begin; i < part.end; ++i) {
    const AlignedBox3d box = box_of(corners_of(mesh, i));
    if (!box.intersects(other)) continue;
    result.first.push_back(i);
    result.second.push_back(box);
  }
  return result;
}

/// Whether the shader fades out the later of two parts over the earlier one.
bool fades_over(const PartModel& later, std::size_t earlier) {
  return std::ranges::any_of(later.occluders, [&](const Capsule& occluder) {
    return occluder.meets && occluder.part == earlier;
  });
}

}  // namespace

PartIntersections find_intersections(const Mesh& mesh, std::span<const PartModel> parts) {
  const std::vector<PartTriangles> triangles = triangles_of_parts(mesh);
  PartIntersections result(parts.size());
  AlignedBox3d whole;
  for (const PartTriangles& part : triangles) whole.extend(part.box);
  // Parts that only touch do not intersect. The tolerance is far above the rounding to single
  // precision.
  const double touch = 1e-5 * whole.diagonal().norm();
  const auto find_between = [&](std::size_t earlier, std::size_t later) {
    const auto [near, boxes] = triangles_near(mesh, triangles[earlier], triangles[later].box);
    const TriangleTree tree(near.begin(), near.end(), boxes.begin(), boxes.end());
    for (const Number one : triangles_near(mesh, triangles[later], triangles[earlier].box).first) {
      TriangleQuery query(mesh, one, touch);
      Eigen::BVIntersect(tree, query);
      for (const auto& [other, ends] : query.found()) {
        result[earlier].push_back(edge_of(mesh, other, one, ends[0], ends[1]));
        result[later].push_back(edge_of(mesh, one, other, ends[1], ends[0]));
      }
    }
  };
  for (std::size_t later = 1; later < parts.size(); ++later) {
    for (std::size_t earlier = 0; earlier < later; ++earlier) {
      if (!fades_over(parts[later], earlier)) find_between(earlier, later);
    }
  }
  return result;
}

}  // namespace twrench::picture
