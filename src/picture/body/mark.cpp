#include "picture/body/mark.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "picture/body/bounding_radius.h"
#include "picture/body/half_turn.h"
#include "picture/body/revolution.h"
#include "picture/space/glm_from_eigen.h"

namespace twrench::picture {
namespace {

using body::PrincipalAxes;
using Eigen::Vector3d;

/// An interval of positions along a direction, cm.
struct Interval {
  double begin, end;
};

Interval interval_along(std::span<const body::Part> parts, const Vector3d& direction) {
  Interval all{std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()};
  for (const body::Part& part : parts) {
    all.begin = std::min(all.begin, -extent_along(part, -direction));
    all.end = std::max(all.end, extent_along(part, direction));
  }
  return all;
}

/// The row that maps a position to its component along a unit vector, from `origin` in `unit`.
glm::vec4 row_along(const Vector3d& direction, double origin, double unit) {
  return {glm_from_eigen((direction / unit).eval()), static_cast<float>(-origin / unit)};
}

/// The directions towards the white side of a painted end and towards that end. Equal moments leave
/// them open, at least in part; then they follow the axes of the first part.
struct EndAxes {
  Vector3d side, up;
};

EndAxes end_axes(std::span<const body::Part> parts, const PrincipalAxes& principal) {
  const Eigen::Matrix3d& own = parts.front().body_from_part;
  const std::optional<Vector3d> reversed = reversed_axis(principal);
  const Vector3d up = reversed.value_or(own.col(1));
  if (reversed && up == principal.axes.col(PrincipalAxes::intermediate)) {
    return {principal.axes.col(PrincipalAxes::least), up};
  }
  Eigen::Index most_across = 0;
  (own.transpose() * up).cwiseAbs().minCoeff(&most_across);
  const Vector3d side = own.col(most_across);
  return {(side - side.dot(up) * up).normalized(), up};
}

/// A stripe through the poles of a body of revolution, wider at one of them, which shows which one
/// is up.
MarkFromBody stripe(std::span<const body::Part> parts, const Interval& along,
                    const Vector3d& axis) {
  constexpr float half_width = 0.13F, widening = 0.05F;  // in radii of the body about its axis
  const AcrossFromBody across = across_from_body(parts).front();
  const auto& [begin, end] = along;
  glm::vec4 width = row_along(axis, (begin + end) / 2, (end - begin) / 2) * widening;
  width.w += half_width;
  return {across[0], across[1], width};
}

/// Whether a body of revolution is so long that a stripe would not show which end is up.
bool is_long(std::span<const body::Part> parts, const Interval& along, const Vector3d& axis) {
  const auto [left, right] = interval_along(parts, axis.unitOrthogonal());
  return along.end - along.begin > 1.5 * (right - left);
}

}  // namespace

MarkFromBody painted_end(std::span<const body::Part> parts, const PrincipalAxes& principal) {
  constexpr double share = 0.25;  // of the extent along the axis
  const auto [side, up] = end_axes(parts, principal);
  const auto [bottom, top] = interval_along(parts, up);
  const double length = top - bottom, edge = top - share * length;
  std::vector<body::Part> painted;
  for (const body::Part& part : parts) {
    if (extent_along(part, up) > edge) painted.push_back(part);
  }
  const auto [left, right] = interval_along(painted, side);
  return {row_along(side, (left + right) / 2, length), glm::vec4(0), row_along(up, edge, length)};
}

std::optional<MarkFromBody> mark_from_body(std::span<const body::Part> parts,
                                           std::span<const std::size_t> looks,
                                           const PrincipalAxes& principal) {
  if (const auto axis = axis_of_revolution(parts)) {
    const Interval along = interval_along(parts, *axis);
    if (!is_long(parts, along, *axis)) return stripe(parts, along, *axis);
  } else if (!looks_the_same_turned_over(parts, looks, principal)) {
    return std::nullopt;
  }
  return painted_end(parts, principal);
}

}  // namespace twrench::picture
