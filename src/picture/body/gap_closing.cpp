#include "picture/body/gap_closing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "picture/shapes/shapes.h"

namespace twrench::picture {
namespace {

using Eigen::Vector3d;

bool part_holds(const body::Part& part, const Vector3d& point, double margin) {
  const Vector3d local = part.body_from_part.transpose() * (point - part.position);
  return std::visit([&](const auto& solid) { return holds(solid, local, margin); }, part.shape);
}

/// The point of the middle that is next to `start`.
Vector3d nearest_point(const Middle& middle, const Vector3d& start) {
  const auto& [radius, half] = middle;
  return radius * Vector3d(start.x(), start.y(), 0).normalized() +
         std::clamp(start.z(), -half, half) * Vector3d::UnitZ();
}

/// Returns the distance from `start`, along the unit vector `direction`, to the point closest to
/// the part's middle or, if the part is a solid of revolution that is not parallel to `direction`,
/// closest to its axis.
double depth_of_middle(const body::Part& part, const Vector3d& start, const Vector3d& direction) {
  const ShapeTraits traits = traits_of(part.shape);
  const Vector3d local = part.body_from_part.transpose() * (start - part.position);
  const Vector3d middle = nearest_point(traits.middle, local);
  const Vector3d to_middle = part.position + part.body_from_part * middle - start;
  Vector3d across = direction;
  const bool has_full_axis = traits.symmetry == of_revolution && traits.occluder.has_value();
  if (has_full_axis) {
    const Vector3d axis = part.body_from_part.col(2);
    const Vector3d part_across = direction - axis.dot(direction) * axis;
    if (part_across.norm() > 1e-3) across = part_across / part_across.squaredNorm();
  }
  return to_middle.dot(across);
}

/// Returns how far the end of a cylinder towards `direction`, with the centre of its face at `end`,
/// extends into `other`; nothing if the two do not touch or the longer cylinder would be visible.
std::optional<double> way_into(const body::Part& other, const Vector3d& end,
                               const Vector3d& direction, double radius) {
  const double tolerance = 1e-3 * radius;  // a gap too small to see counts as touching
  const bool touches = part_holds(other, end + tolerance * direction, tolerance) &&
                       !part_holds(other, end - 3 * tolerance * direction, tolerance);
  if (!touches) return std::nullopt;
  const double depth = depth_of_middle(other, end, direction);
  const Eigen::Matrix3d frame = body::frame_with_z_along(direction);
  constexpr int rim_points = 64;
  for (int i = 0; i < rim_points; ++i) {
    const double angle = 2 * std::numbers::pi * i / rim_points;
    const Vector3d rim(radius * std::cos(angle), radius * std::sin(angle), depth);
    if (!part_holds(other, end + frame * rim, tolerance)) return std::nullopt;
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
