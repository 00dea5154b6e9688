#include "render/body/revolution.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <vector>

namespace twrench::render {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// A diagonal tensor with the symmetry of the shape under rotations by small angles.
struct SymmetryTensor {
  Vector3d operator()(const body::Cylinder&) const { return {1, 1, 0}; }
  Vector3d operator()(const body::Box&) const { return {1, 2, 3}; }
  Vector3d operator()(const body::Ellipsoid& e) const { return e.radii / e.radii.maxCoeff(); }
};

bool turns_into_itself(const body::Part& part, const Vector3d& axis) {
  constexpr double round_off = 1e-9;
  const Vector3d& place = part.position;
  if ((place - place.dot(axis) * axis).norm() > round_off * body::bounding_radius(part.shape))
    return false;
  const Matrix3d Q = Eigen::AngleAxisd(1, axis).toRotationMatrix() * part.body_from_part;
  const Matrix3d tensor = std::visit(SymmetryTensor(), part.shape).asDiagonal();
  const Matrix3d& R = part.body_from_part;
  return (Q * tensor * Q.transpose() - R * tensor * R.transpose()).norm() <= round_off;
}

}  // namespace

std::optional<Vector3d> axis_of_revolution(std::span<const body::Part> parts) {
  std::vector<Vector3d> candidates;
  for (const body::Part& part : parts) {
    for (const int i : {2, 0, 1}) candidates.emplace_back(part.body_from_part.col(i));
    if (!part.position.isZero()) candidates.push_back(part.position.normalized());
  }
  const auto found = std::ranges::find_if(candidates, [&](const Vector3d& axis) {
    return std::ranges::all_of(
        parts, [&](const body::Part& part) { return turns_into_itself(part, axis); });
  });
  return found == candidates.end() ? std::nullopt : std::optional(*found);
}

}  // namespace twrench::render
