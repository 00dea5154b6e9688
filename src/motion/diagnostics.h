#pragma once

#include "motion/free_body.h"

namespace twrench {

/// Rotational kinetic energy 1/2 omega . (I omega) in g cm^2/s^2, eq. (14).
double energy(const Eigen::Matrix3d& inertia, const Eigen::Vector3d& omega);

/// How far a sample has left what the exact motion conserves. All are zero at t = 0.
struct Diagnostics {
  double energy;               ///< g cm^2/s^2
  double energy_drift;         ///< energy / energy(0) - 1; 0 for a body at rest
  double orthogonality_error;  ///< Frobenius norm of X^T X - Id
  double momentum_error;       ///< |X I omega - L| / |L|; 0 for a body at rest
};

/// `initial_energy` is that of the sample at t = 0.
Diagnostics diagnose(const FreeBody& body, double initial_energy, const Sample& sample);

}  // namespace twrench
