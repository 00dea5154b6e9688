#include "check/conventions/attitude.h"

#include <Eigen/Geometry>

namespace twrench::check {

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

}  // namespace twrench::check
