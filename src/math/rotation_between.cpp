#include "math/rotation_between.h"

namespace twrench::so3 {

Eigen::Quaterniond rotation_between(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const Eigen::Vector3d a = from.normalized(), b = to.normalized();
  Eigen::Vector3d axis = a.cross(b).normalized();
  // Closer to opposite directions, the cross product has no digits.
  constexpr double least_sum = 1e-15;
  const double sum = (a + b).norm();
  if (sum < least_sum) axis = a.unitOrthogonal();
  // Half of the angle in an accurate form: its cosine is |a + b|/2, its sine |a - b|/2.
  Eigen::Quaterniond turn;
  turn.w() = 0.5 * sum;
  turn.vec() = 0.5 * (a - b).norm() * axis;
  return turn;
}

}  // namespace twrench::so3
