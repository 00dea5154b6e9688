#pragma once

#include <twrench/motion/free_body.h>

#include <Eigen/Geometry>

namespace twrench::motion::unchecked {

// FreeBody's functions of the same names without checks. A step that diverges is reported by its
// propagator.

inline Eigen::Vector3d rigid_velocity(const FreeBody& body, const Eigen::Vector3d& m) {
  return body.inverse() * (m - body.interior().wheel);
}

inline Eigen::Vector3d turning_rate(const FreeBody& body, const Eigen::Vector3d& m) {
  if (body.is_rigid()) return body.inverse() * m;
  const Eigen::Vector3d w = rigid_velocity(body, m);
  return w + body.energy_loss() * m.cross(w);
}

}  // namespace twrench::motion::unchecked
