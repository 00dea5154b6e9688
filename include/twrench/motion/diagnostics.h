#pragma once

#include <twrench/motion/free_body.h>

namespace twrench::motion {

/// Returns the rotational kinetic energy 1/2 omega . (I omega) in g cm^2/s^2, eq. (14). Throws
/// OutOfRange about "inertia" or "omega" unless it is finite.
double energy(const Eigen::Matrix3d& inertia, const Eigen::Vector3d& omega);

/// How far a sample deviates from the quantities that the exact motion conserves. All errors are
/// zero at t = 0.
struct Diagnostics {
  double energy;               ///< Kinetic energy in g cm^2/s^2.
  double energy_drift;         ///< Relative drift energy / energy(0) - 1; 0 for a body at rest.
  double orthogonality_error;  ///< Frobenius norm of X^T X - Id.
  double momentum_error;       ///< |X I omega - L| / |L|; 0 for a body at rest.
};

/// Computes the diagnostics of a sample. `initial_energy` is the energy of the sample at t = 0, in
/// g cm^2/s^2. Throws OutOfRange about "initial_energy" unless it is finite and not negative, and
/// about "X" or "omega" unless those of the sample are finite.
Diagnostics diagnose(const FreeBody& body, double initial_energy, const Sample& sample);

}  // namespace twrench::motion
