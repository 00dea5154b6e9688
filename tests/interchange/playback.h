#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

namespace twrench::interchange {

/// The key before a time, and the fraction of the way to the next key, 0 to 1.
struct Between {
  std::size_t key;
  double share;
};

inline Between between(const std::vector<float>& times, double time) {
  const auto after = std::upper_bound(times.begin() + 1, times.end() - 1, time);
  const auto key = static_cast<std::size_t>(after - times.begin()) - 1;
  return {key, std::clamp((time - times[key]) / (double{times[key + 1]} - times[key]), 0.0, 1.0)};
}

enum class Interpolation { slerp, nlerp };

/// The rotation that a player shows, by glTF's definition of LINEAR (slerp) or, as in several
/// programs, by normalised linear interpolation (nlerp).
inline Eigen::Quaterniond played_rotation(const std::vector<float>& times,
                                          const std::vector<float>& rotations, double time,
                                          Interpolation interpolation = Interpolation::slerp) {
  const auto [key, share] = between(times, time);
  const Eigen::Vector4d a = Eigen::Vector4f(&rotations[4 * key]).cast<double>();
  const Eigen::Vector4d b = Eigen::Vector4f(&rotations[4 * key + 4]).cast<double>();
  const double angle = std::acos(std::min(a.normalized().dot(b.normalized()), 1.0));
  Eigen::Vector4d q = (1 - share) * a + share * b;
  if (interpolation == Interpolation::slerp && angle > 1e-6)
    q = std::sin((1 - share) * angle) * a + std::sin(share * angle) * b;
  return Eigen::Quaterniond(q.normalized());
}

inline double angle_between(const Eigen::Quaterniond& q, const Eigen::Matrix3d& X) {
  const Eigen::Quaterniond d = q.conjugate() * Eigen::Quaterniond(X);
  return 2 * std::atan2(d.vec().norm(), std::abs(d.w()));
}

inline double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace twrench::interchange
