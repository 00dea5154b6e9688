// The functions of stepper.h without their checks. If a method that leaves SO(3) overflows, its
// propagator reports that the motion has diverged.
#pragma once

#include <twrench/motion/free_body.h>
#include <twrench/motion/stepper.h>

#include <Eigen/Geometry>

namespace twrench::motion::unchecked {

// FreeBody's functions of the same names without checks. A step that diverges is reported by its
// propagator.

inline Eigen::Vector3d rigid_velocity(const FreeBody& body, const Eigen::Vector3d& m) {
  return body.inverse() * (m - body.interior().wheel);
}

/// The rate of a rigid body alone.
struct RigidRate {
  const FreeBody& body;
  Eigen::Vector3d operator()(const Eigen::Vector3d& m) const { return body.inverse() * m; }
};

/// The rate of any body.
struct InteriorRate {
  const FreeBody& body;
  Eigen::Vector3d operator()(const Eigen::Vector3d& m) const {
    const Eigen::Vector3d w = rigid_velocity(body, m);
    return w + body.energy_loss() * m.cross(w);
  }
};

inline Eigen::Vector3d turning_rate(const FreeBody& body, const Eigen::Vector3d& m) {
  return body.is_rigid() ? RigidRate{body}(m) : InteriorRate{body}(m);
}

Eigen::Vector3d angular_velocity(const FreeBody& body, const Method& method,
                                 const Eigen::Matrix3d& X);

Step take_step(const FreeBody& body, const Method& method, const Eigen::Matrix3d& X, double h);

}  // namespace twrench::motion::unchecked
