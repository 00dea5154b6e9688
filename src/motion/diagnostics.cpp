#include <twrench/motion/diagnostics.h>

#include "base/require.h"

namespace twrench::motion {

namespace {

void require_finite_omega(const Eigen::Vector3d& omega) {
  for (const double component : omega) require_finite("omega", component);
}

}  // namespace

double energy(const Eigen::Matrix3d& inertia, const Eigen::Vector3d& omega) {
  for (const double entry : inertia.reshaped()) require_finite("inertia", entry);
  require_finite_omega(omega);
  return 0.5 * omega.dot(inertia * omega);
}

Diagnostics diagnose(const FreeBody& body, double initial_energy, const Sample& sample) {
  require_not_negative("initial_energy", initial_energy);
  for (const double entry : sample.X.reshaped()) require_finite("X", entry);
  Diagnostics d{};
  d.energy = energy(body.inertia(), sample.omega);
  d.energy_drift = initial_energy > 0.0 ? d.energy / initial_energy - 1.0 : 0.0;
  d.orthogonality_error = (sample.X.transpose() * sample.X - Eigen::Matrix3d::Identity()).norm();
  const double size = body.momentum().norm();
  const Eigen::Vector3d missing = sample.X * (body.inertia() * sample.omega) - body.momentum();
  d.momentum_error = size > 0.0 ? missing.norm() / size : 0.0;
  return d;
}

}  // namespace twrench::motion
