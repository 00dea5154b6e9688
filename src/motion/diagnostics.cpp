#include <twrench/math/so3.h>
#include <twrench/motion/diagnostics.h>

#include <Eigen/LU>

#include "base/require.h"

namespace twrench::motion {

namespace {

/// Solves omega = w + a (m x w) for w. The matrix is not singular, because its determinant is 1 +
/// a^2 |m|^2.
Eigen::Vector3d rigid_velocity(const FreeBody& body, const Sample& sample) {
  if (body.energy_loss() == 0) return sample.omega;
  const Eigen::Vector3d am = body.energy_loss() * (sample.X.transpose() * body.momentum());
  return (Eigen::Matrix3d::Identity() + so3::hat(am)).inverse() * sample.omega;
}

}  // namespace

double energy(const Eigen::Matrix3d& inertia, const Eigen::Vector3d& omega) {
  require_finite_entries("inertia", inertia);
  require_finite_entries("omega", omega);
  return 0.5 * omega.dot(inertia * omega);
}

Diagnostics diagnose(const FreeBody& body, double initial_energy, const Sample& sample) {
  require_not_negative("initial_energy", initial_energy);
  require_finite_entries("X", sample.X);
  Diagnostics d{};
  const Eigen::Vector3d w = rigid_velocity(body, sample);
  d.energy = energy(body.inertia(), w);
  d.energy_drift = initial_energy > 0.0 ? d.energy / initial_energy - 1.0 : 0.0;
  d.orthogonality_error = (sample.X.transpose() * sample.X - Eigen::Matrix3d::Identity()).norm();
  const double size = body.momentum().norm();
  const Eigen::Vector3d missing =
      sample.X * (body.inertia() * w + body.interior().wheel) - body.momentum();
  d.momentum_error = size > 0.0 ? missing.norm() / size : 0.0;
  return d;
}

}  // namespace twrench::motion
