#include "math/rotation_between.h"

#include <cmath>

namespace twrench::so3 {

Eigen::Quaterniond rotation_between(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const Eigen::Vector3d a = from.normalized(), b = to.normalized();
  const double cosine = b.dot(a);
  // Closer to a half turn, the cross product has too few digits.
  constexpr double least_cosine = -1 + 1e-12;
  Eigen::Quaterniond turn;
  if (cosine < least_cosine) {
    turn.w() = 0;
    turn.vec() = a.unitOrthogonal();
    return turn;
  }
  const double twice_half_cosine = std::sqrt((1 + cosine) * 2);
  turn.w() = twice_half_cosine * 0.5;
  turn.vec() = a.cross(b) * (1 / twice_half_cosine);
  return turn;
}

}  // namespace twrench::so3
