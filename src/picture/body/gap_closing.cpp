#include "picture/body/gap_closing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace twrench::picture {
namespace {

using Eigen::Vector3d;

/// Whether `point`, in the shape's own frame, lies in the shape grown by `margin` cm on all sides.
struct Holds {
  Vector3d point;
  double margin;

  bool operator()(const body::Cylinder& c) const {
    return across() <= c.radius + margin && std::abs(point.z()) <= c.length / 2 + margin;
  }
  bool operator()(const body::Box& b) const {
    return (point.cwiseAbs().array() <= b.size.array() / 2 + margin).all();
  }
  bool operator()(const body::Ellipsoid& e) const {
    return point.cwiseQuotient((e.radii.array() + margin).matrix()).norm() <= 1;
  }
  bool operator()(const body::Cone& c) const {
    const double share = std::clamp(point.z() / c.length + 0.5, 0.0, 1.0);
    const double radius = c.radius + share * (c.top_radius - c.radius);
    const double slant = std::hypot(c.length, c.radius - c.top_radius) / c.length;
    return across() <= radius + slant * margin && std::abs(point.z()) <= c.length / 2 + margin;
  }
  bool operator()(const body::Torus& t) const {
    return std::hypot(across() - t.radius, point.z()) <= t.tube_radius + margin;
  }
  bool operator()(const body::Capsule& c) const {
    const double beyond = std::max(std::abs(point.z()) - c.length / 2, 0.0);
    return std::hypot(across(), beyond) <= c.radius + margin;
  }
  bool operator()(const body::Tube& t) const {
    return across() <= t.radius + margin && across() >= t.inner_radius - margin &&
           std::abs(point.z()) <= t.length / 2 + margin;
  }
  bool operator()(const body::Mesh&) const { return false; }  // is drawn as it is given

  double across() const { return std::hypot(point.x(), point.y()); }
};

bool holds(const body::Part& part, const Vector3d& point, double margin) {
  const Vector3d local = part.body_from_part.transpose() * (point - part.position);
  return std::visit(Holds{local, margin}, part.shape);
}

/// The middle of a part, where it is widest: a point, or for some shapes a curve or a surface about
/// the axis, of which the point next to `start` counts.
struct Middle {
  Vector3d start;

  Vector3d operator()(const body::Torus& t) const { return at_radius(t.radius); }
  Vector3d operator()(const body::Tube& t) const {
    const double half = t.length / 2;
    return at_radius((t.radius + t.inner_radius) / 2) +
           std::clamp(start.z(), -half, half) * Vector3d::UnitZ();
  }
  Vector3d operator()(const auto&) const { return Vector3d::Zero(); }

  Vector3d at_radius(double radius) const {
    return radius * Vector3d(start.x(), start.y(), 0).normalized();
  }
};

bool has_full_axis(const body::Shape& shape) {
  return std::holds_alternative<body::Cylinder>(shape) ||
         std::holds_alternative<body::Cone>(shape) || std::holds_alternative<body::Capsule>(shape);
}

/// The distance from `start` along the unit vector `direction` at which it comes closest to the
/// part's axis, of a solid of revolution that is not parallel to it, or to its middle.
double depth_of_middle(const body::Part& part, const Vector3d& start, const Vector3d& direction) {
  const Vector3d local = part.body_from_part.transpose() * (start - part.position);
  const Vector3d middle = std::visit(Middle{local}, part.shape);
  const Vector3d to_middle = part.position + part.body_from_part * middle - start;
  Vector3d across = direction;
  if (has_full_axis(part.shape)) {
    const Vector3d axis = part.body_from_part.col(2);
    const Vector3d part_across = direction - axis.dot(direction) * axis;
    if (part_across.norm() > 1e-3) across = part_across / part_across.squaredNorm();
  }
  return to_middle.dot(across);
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

}  // namespace twrench::picture
