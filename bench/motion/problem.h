#pragma once

#include <twrench/motion/free_body.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <functional>
#include <string>
#include <vector>

namespace twrench::bench {

/// A motion whose end is known. The inertia is diagonal; X(0) = Id.
struct Problem {
  std::string name;
  motion::FreeBody body;
  double t_end;           ///< Duration in s.
  Eigen::Matrix3d X_end;  ///< The exact attitude at the end.
};

/// An integrator, and the parameters (tolerances or numbers of steps) to try, cheapest first. `run`
/// goes from t = 0 to t_end, including initialisation and clean-up.
struct Candidate {
  std::string library, method;
  std::vector<double> parameters;
  std::function<Eigen::Matrix3d(const Problem&, double parameter)> run;
};

/// Returns 10^-2 to 10^-16 in quarters of a decade.
std::vector<double> tolerances();
/// Returns 2^5 to 2^20 in quarters of an octave.
std::vector<double> step_counts();

std::vector<Candidate> odeint_candidates();
std::vector<Candidate> sundials_candidates();
std::vector<Candidate> gsl_candidates();
std::vector<Candidate> own_candidates();

/// Prints the cost of ten thousand samples during the motion.
void compare_samples(const Problem& problem, int rounds);

/// Returns the rotation space_from_body of the quaternion q = (w, x, y, z), which it normalises.
inline Eigen::Matrix3d rotation(const double* q) {
  return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix();
}

/// q' = 1/2 q (0, omega).
inline void quaternion_rate(const double* q, const double* w, double* rate) {
  rate[0] = -0.5 * (q[1] * w[0] + q[2] * w[1] + q[3] * w[2]);
  rate[1] = 0.5 * (q[0] * w[0] + q[2] * w[2] - q[3] * w[1]);
  rate[2] = 0.5 * (q[0] * w[1] + q[3] * w[0] - q[1] * w[2]);
  rate[3] = 0.5 * (q[0] * w[2] + q[1] * w[1] - q[2] * w[0]);
}

/// Euler's equations together with the quaternion: y = (omega, q).
struct VelocityForm {
  static constexpr std::size_t size = 7;
  static constexpr const char* name = "omega, q";
  using State = std::array<double, size>;

  explicit VelocityForm(const motion::FreeBody& body)
      : start{body.omega()[0], body.omega()[1], body.omega()[2], 1} {
    const Eigen::Vector3d I = body.inertia().diagonal();
    euler = {(I[1] - I[2]) / I[0], (I[2] - I[0]) / I[1], (I[0] - I[1]) / I[2]};
  }

  void rate(const double* y, double* dydt) const {
    dydt[0] = euler[0] * y[1] * y[2];
    dydt[1] = euler[1] * y[2] * y[0];
    dydt[2] = euler[2] * y[0] * y[1];
    quaternion_rate(y + 3, y, dydt + 3);
  }
  static Eigen::Matrix3d attitude(const double* y) { return rotation(y + 3); }

  State start;
  std::array<double, 3> euler;
};

/// The quaternion alone, y = q, with omega = I^-1 R(q)^T L.
struct MomentumForm {
  static constexpr std::size_t size = 4;
  static constexpr const char* name = "q, L";
  using State = std::array<double, size>;

  explicit MomentumForm(const motion::FreeBody& body) : start{1, 0, 0, 0} {
    const Eigen::Vector3d I = body.inertia().diagonal();
    for (std::size_t i = 0; i < 3; ++i) {
      L[i] = body.momentum()[static_cast<int>(i)];
      inverse[i] = 1 / I[static_cast<int>(i)];
    }
  }

  void rate(const double* q, double* dqdt) const {
    const double w = q[0], x = q[1], y = q[2], z = q[3];
    const double xx = x * x, yy = y * y, zz = z * z, xy = x * y, yz = y * z, zx = z * x;
    const double wx = w * x, wy = w * y, wz = w * z;
    const double omega[3] = {
        inverse[0] * ((1 - 2 * (yy + zz)) * L[0] + 2 * ((xy + wz) * L[1] + (zx - wy) * L[2])),
        inverse[1] * ((1 - 2 * (zz + xx)) * L[1] + 2 * ((yz + wx) * L[2] + (xy - wz) * L[0])),
        inverse[2] * ((1 - 2 * (xx + yy)) * L[2] + 2 * ((zx + wy) * L[0] + (yz - wx) * L[1]))};
    quaternion_rate(q, omega, dqdt);
  }
  static Eigen::Matrix3d attitude(const double* y) { return rotation(y); }

  State start;
  std::array<double, 3> L, inverse;
};

}  // namespace twrench::bench
