#include "picture/body/revolution.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <vector>

#include "picture/shapes/shapes.h"
#include "picture/space/glm_from_eigen.h"

namespace twrench::picture {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

std::vector<Vector3d> symmetries_of(std::span<const body::Part> parts) {
  std::vector<Vector3d> symmetries;
  for (const body::Part& part : parts) symmetries.push_back(traits_of(part.shape).symmetry);
  return symmetries;
}

/// How far the shape extends from its own origin along a unit vector in body axes.
double radius_along(const body::Part& part, const Vector3d& direction) {
  const Vector3d own = part.body_from_part.transpose() * direction;
  return own.dot(body::support(part.shape, own));
}

bool turns_into_itself(const body::Part& part, const Vector3d& symmetry, const Vector3d& axis) {
  constexpr double round_off = 1e-9;
  const Vector3d& place = part.position;
  if ((place - place.dot(axis) * axis).norm() > round_off * body::bounding_radius(part.shape))
    return false;
  const Matrix3d Q = Eigen::AngleAxisd(1, axis).toRotationMatrix() * part.body_from_part;
  const Matrix3d tensor = symmetry.asDiagonal();
  const Matrix3d& R = part.body_from_part;
  return (Q * tensor * Q.transpose() - R * tensor * R.transpose()).norm() <= round_off;
}

/// The rows of the matrix that maps (position, 1) in body axes, cm, to the position across an axis,
/// the z axis of `frame` through `centre`, in units of `radius`.
AcrossFromBody across_axis(const Matrix3d& frame, const Vector3d& centre, double radius) {
  AcrossFromBody rows;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Vector3d row = frame.col(static_cast<Eigen::Index>(i)) / radius;
    rows[i] = glm::vec4(glm_from_eigen(row), static_cast<float>(-row.dot(centre)));
  }
  return rows;
}

/// The same for all parts of a body of revolution, in units of its largest radius about its axis.
AcrossFromBody across_all(std::span<const body::Part> parts, const Vector3d& axis) {
  const Matrix3d frame = body::frame_with_z_along(axis);
  double radius = 0;
  for (const body::Part& part : parts) {
    radius = std::max(radius, radius_along(part, frame.col(0)));
  }
  return across_axis(frame, Vector3d::Zero(), radius);
}

/// Returns the axis about which all parts are symmetric.
std::optional<Vector3d> common_axis(std::span<const body::Part> parts,
                                    std::span<const Vector3d> symmetries) {
  std::vector<Vector3d> candidates;
  for (const body::Part& part : parts) {
    for (const int i : {2, 0, 1}) candidates.emplace_back(part.body_from_part.col(i));
    if (!part.position.isZero()) candidates.push_back(part.position.normalized());
  }
  const auto is_common = [&](const Vector3d& axis) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (!turns_into_itself(parts[i], symmetries[i], axis)) return false;
    }
    return true;
  };
  const auto found = std::ranges::find_if(candidates, is_common);
  return found == candidates.end() ? std::nullopt : std::optional(*found);
}

}  // namespace

std::optional<Vector3d> axis_of_revolution(std::span<const body::Part> parts) {
  return common_axis(parts, symmetries_of(parts));
}

std::vector<AcrossFromBody> across_from_body(std::span<const body::Part> parts) {
  const std::vector<Vector3d> symmetries = symmetries_of(parts);
  if (const auto axis = common_axis(parts, symmetries)) {
    return std::vector(parts.size(), across_all(parts, *axis));
  }
  std::vector<AcrossFromBody> result;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Matrix3d& frame = parts[i].body_from_part;
    result.push_back(
        symmetries[i] == of_revolution
            ? across_axis(frame, parts[i].position, radius_along(parts[i], frame.col(0)))
            : AcrossFromBody{});
  }
  return result;
}

}  // namespace twrench::picture
