#pragma once

#include <twrench/motion/exact.h>

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "math/elliptic.h"
#include "math/so3_formulas.h"

namespace twrench::motion {

/// The implementation of ExactMotion, with the same functions. Its layout is hidden from programs
/// that link the library, so it can change.
class ExactSolution {
 public:
  static bool covers(const FreeBody& body);

  explicit ExactSolution(const FreeBody& body);

  Sample at(double t) const;
  void at(std::span<const double> times, std::span<double> X, std::span<double> omega,
          unsigned threads) const;
  std::vector<Sample> at(std::span<const double> times, unsigned threads) const;

  ExactMotion::Kind kind() const { return kind_; }
  std::optional<ExactMotion::Flips> flips() const;
  std::optional<double> nutation_period() const;
  std::optional<ExactMotion::Phase> phase() const;

 private:
  /// The constants of a motion, in the axes (a, b, c) of docs/exact.md: L circles a, and b is the
  /// intermediate axis. A steady spin also has an orbit, with L along a and k = 0.
  struct Orbit {
    elliptic::Jacobi jacobi;
    double m, mc;               ///< Parameter k^2, and 1 - k^2.
    double rate;                ///< lambda = du/dt in 1/s.
    double phase;               ///< u at t = 0.
    double quarter_turns;       ///< Mean rate of psi/2, quarter turns per second.
    double dynamic_rate;        ///< omega . m / G in rad/s.
    Eigen::Vector3d amplitude;  ///< Amplitudes of mu = m/G = (a dn u, b sn u, c cn u).
    /// Maps the quaternion (w, x, y, z) of Rot(e_a, psi) P, eq. (E5), to that of X. Both are
    /// determined up to a factor.
    so3::Matrix4 attitude_from_turn = so3::Matrix4::Zero();
    Eigen::Matrix3d omega_from_mu = Eigen::Matrix3d::Zero();  ///< In rad/s.
  };
  struct Samples;

  void prepare(const FreeBody& body);
  void prepare_with_wheel(const FreeBody& body);
  static Orbit steady_orbit(const Eigen::Vector3d& omega);
  static Orbit orbit(double G, const Eigen::Vector3d& mu, const Eigen::Vector3d& I, double D2);
  /// Returns the quaternion of Rot(e_a, psi) P at t = 0, up to a factor.
  static so3::Quaternion turn_at_start(const Orbit& orbit);
  template <class Write>
  void for_each_block(std::span<const double> times, unsigned threads, const Write& write) const;

  bool has_intermediate_axis_ = false;
  ExactMotion::Kind kind_ = ExactMotion::Kind::steady;
  Sample start_;  ///< The given state at t = 0. The constants only reproduce it to rounding.
  Orbit orbit_;
};

}  // namespace twrench::motion
