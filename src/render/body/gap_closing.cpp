#include "render/body/gap_closing.h"

#include <cmath>
#include <numbers>
#include <optional>

namespace twrench::render {
namespace {

using Eigen::Vector3d;

/// Whether `point`, in the shape's own frame, lies in the shape grown by `margin` cm on all sides.
struct Holds {
  Vector3d point;
  double margin;

  bool operator()(const body::Cylinder& c) const {
    return std::hypot(point.x(), point.y()) <= c.radius + margin &&
           std::abs(point.z()) <= c.length / 2 + margin;
  }
  bool operator()(const body::Box& b) const {
    return (point.cwiseAbs().array() <= b.size.array() / 2 + margin).all();
  }
  bool operator()(const body::Ellipsoid& e) const {
    return point.cwiseQuotient((e.radii.array() + margin).matrix()).norm() <= 1;
  }
  bool operator()(const auto&) const { return false; }
};

bool holds(const body::Part& part, const Vector3d& point, double margin) {
  const Vector3d local = part.body_from_part.transpose() * (point - part.position);
  return std::visit(Holds{local, margin}, part.shape);
}

/// The distance from `start` along the unit vector `direction` at which it comes closest to the
/// part's axis (of a cylinder that is not parallel) or its centre.
double depth_of_middle(const body::Part& part, const Vector3d& start, const Vector3d& direction) {
  Vector3d to_centre = part.position - start;
  Vector3d across = direction;
  if (std::holds_alternative<body::Cylinder>(part.shape)) {
    const Vector3d axis = part.body_from_part.col(2);
    const Vector3d part_across = direction - axis.dot(direction) * axis;
    if (part_across.norm() > 1e-3) across = part_across / part_across.squaredNorm();
  }
  return to_centre.dot(across);
}

/// How far the end of `cylinder` towards `direction`, with the centre of its face at `end`, extends
/// into `other`; nothing if the two do not touch or the longer cylinder would show.
std::optional<double> way_into(const body::Part& other, const Vector3d& end,
                               const Vector3d& direction, double radius) {
  const double tolerance = 1e-3 * radius;  // a gap too small to see counts as touching
  const bool touches = holds(other, end + tolerance * direction, tolerance) &&
                       !holds(other, end - 3 * tolerance * direction, tolerance);
  if (!touches) return std::nullopt;
  const double depth = depth_of_middle(other, end, direction);
  const Eigen::Matrix3d frame = body::frame_with_z_along(direction);
  constexpr int rim_points = 64;
  for (int i = 0; i < rim_points; ++i) {
    const double angle = 2 * std::numbers::pi * i / rim_points;
    const Vector3d rim(radius * std::cos(angle), radius * std::sin(angle), depth);
    if (!holds(other, end + frame * rim, tolerance)) return std::nullopt;
  }
  return depth;
}

/// Extends one end of the cylinder; `sign` is +1 for the end on its +z side, -1 for the other.
void join_end(body::Part& part, double sign, std::span<const body::Part> parts, std::size_t self) {
  auto& cylinder = std::get<body::Cylinder>(part.shape);
  const Vector3d direction = sign * part.body_from_part.col(2);
  const Vector3d end = part.position + cylinder.length / 2 * direction;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i == self) continue;
    const auto depth = way_into(parts[i], end, direction, cylinder.radius);
    if (!depth) continue;
    cylinder.length += *depth;
    part.position += *depth / 2 * direction;
    return;
  }
}

}  // namespace

std::vector<body::Part> close_gaps(std::span<const body::Part> parts) {
  std::vector<body::Part> result(parts.begin(), parts.end());
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (!std::holds_alternative<body::Cylinder>(result[i].shape)) continue;
    join_end(result[i], +1, parts, i);
    join_end(result[i], -1, parts, i);
  }
  return result;
}

}  // namespace twrench::render
