#include <twrench/motion/diagnostics.h>

namespace twrench::motion {

double energy(const Eigen::Matrix3d& inertia, const Eigen::Vector3d& omega) {
  return 0.5 * omega.dot(inertia * omega);
}

Diagnostics diagnose(const FreeBody& body, double initial_energy, const Sample& sample) {
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
