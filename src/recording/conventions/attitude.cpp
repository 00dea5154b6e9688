#include "recording/conventions/attitude.h"

#include <Eigen/Geometry>

namespace twrench::recording {

Axes axes_of(const std::string& sequence) {
  Axes axes{};
  for (std::size_t i = 0; i < 3; ++i) axes[i] = sequence.at(i) - 'x';
  return axes;
}

std::array<std::size_t, 3> angle_places(const Axes& axes) {
  if (axes[0] == axes[2]) return {0, 1, 2};
  std::array<std::size_t, 3> places{};
  for (std::size_t i = 0; i < 3; ++i) places[i] = static_cast<std::size_t>(2 - axes[i]);
  return places;
}

Eigen::Matrix3d rotation_by_euler_angles(const Axes& axes, std::span<const double, 3> angles) {
  const std::array<std::size_t, 3> places = angle_places(axes);
  Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
  for (std::size_t i = 0; i < 3; ++i) {
    q = q * Eigen::AngleAxisd(angles[places[i]], Eigen::Vector3d::Unit(axes[i]));
  }
  return q.toRotationMatrix();
}

Eigen::Matrix3d rotation_by_quaternion(std::span<const double, 4> q) {
  return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix();
}

Eigen::Matrix3d rotation_by_vector(const Eigen::Vector3d& v) {
  const double angle = v.stableNorm();
  if (angle == 0) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, v / angle).toRotationMatrix();
}

Eigen::Matrix3d rotation_by_mrp(const Eigen::Vector3d& s) {
  const double length = s.stableNorm();
  // The shadow of long parameters is short, and its square does not overflow.
  const Eigen::Vector3d p = length > 1 ? Eigen::Vector3d(-(s / length) / length) : s;
  const double square = p.squaredNorm();
  Eigen::Quaterniond q;
  q.w() = 1 - square;
  q.vec() = 2 * p;
  return q.normalized().toRotationMatrix();
}

Eigen::Matrix3d rotation_by_rodrigues(const Eigen::Vector3d& g) {
  Eigen::Vector4d q(g[0], g[1], g[2], 1);  // x, y, z, w
  q.stableNormalize();
  return Eigen::Quaterniond(q).toRotationMatrix();
}

}  // namespace twrench::recording
