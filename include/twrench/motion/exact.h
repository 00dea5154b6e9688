#pragma once

#include <twrench/math/elliptic.h>
#include <twrench/motion/free_body.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

namespace twrench::motion {

/// As a number of threads: as many as there are processors.
inline constexpr unsigned all_processors = 0;

/// The motion of a free rigid body in closed form: the solution of eq. (19)-(20) at any t and at a
/// cost independent of t. docs/exact.md derives it and numbers its equations from
/// (E1).
///
/// It covers every positive definite inertia and every momentum: both sides of the separatrix and
/// the separatrix itself, symmetric bodies, the sphere, spin about a principal axis, and rest. The
/// error of X grows as eps |omega| t, and beyond that only as fast as the motion itself amplifies a
/// relative error of eps in the initial velocity. Momentum components below 1e-145 |L| may be
/// treated as zero.
class ExactMotion {
 public:
  /// How the momentum moves in the body frame.
  enum class Kind {
    /// omega is constant: rest, or spin about a principal axis.
    steady,
    /// The momentum circles the axis of least moment.
    about_least,
    /// The momentum circles the axis of greatest moment.
    about_greatest,
    /// The momentum tends to the intermediate axis as t tends to plus or minus infinity.
    separatrix,
  };

  /// Prepares the constants of the motion.
  explicit ExactMotion(const FreeBody& body);

  /// Returns the sample at time t in s, of either sign. Throws OutOfRange unless t is finite.
  Sample at(double t) const;

  /// Evaluates the motion at n times in s, of either sign and in any order, in vector registers and
  /// on up to `threads` threads. Writes the attitudes to `X`, n x 3 x 3 numbers in row-major order
  /// (see attitude_at()), and the angular velocities in body axes, rad/s, to `omega`, n x 3
  /// numbers. An empty array leaves its quantity out. Each has the bits that at(t)
  /// gives for its time alone, whatever the other times and the number of threads. Throws
  /// OutOfRange about "times[i]" unless that is finite, and InvalidArgument about "X" or "omega"
  /// where the size is wrong, before anything is written.
  void at(std::span<const double> times, std::span<double> X, std::span<double> omega,
          unsigned threads = all_processors) const;
  /// The same as samples, in the order of `times`.
  std::vector<Sample> at(std::span<const double> times, unsigned threads = all_processors) const;

  /// Returns which of these the motion is.
  Kind kind() const { return kind_; }

  /// The flips of a motion: sign changes of the component of omega along the intermediate axis.
  /// That axis swings from one side of the plane normal to L to the other and back. With `swing`
  /// near pi the body turns over, as the T-handle does; with `swing` near 0 it wobbles about a
  /// stable axis.
  struct Flips {
    /// Time between flips in s; infinite on the separatrix.
    double interval;
    /// Time of the first flip after t = 0 in s; infinite if there is none.
    double first;
    /// The limit that `interval` approaches near the separatrix, in s.
    double asymptotic_interval;
    /// The angle through which the intermediate axis swings, in rad, from 0 to pi.
    double swing;
    /// |lambda| in 1/s: the rate of the argument of Jacobi's functions, (E3).
    double rate;
    /// Their complementary parameter 1 - k^2, from 0 (the separatrix) to below 1.
    double mc;

    /// Returns whether the intermediate axis swings through at least a right angle: only then is
    /// the motion a turning over rather than a wobble.
    bool turns_over() const { return swing >= std::numbers::pi / 2; }
  };
  /// Returns the flips; nothing for steady motion or for a symmetric body, which has no
  /// intermediate axis.
  std::optional<Flips> flips() const;

  /// Returns the time in s in which the momentum traverses its path in the body frame once: the
  /// period of the nutation. Infinite on the separatrix; nothing for steady motion.
  std::optional<double> nutation_period() const;

  /// The instants, s, of all flips with 0 < t <= t_end, ascending. Throws OutOfRange
  /// unless t_end is finite, and MotionError where there are more than 10^7.
  std::vector<double> flip_times(double t_end) const;

 private:
  // Without Eigen's alignment, which depends on compiler flags: a program may have other flags than
  // the library.
  using Matrix4 = Eigen::Matrix<double, 4, 4, Eigen::DontAlign>;
  using Quaternion = Eigen::Quaternion<double, Eigen::DontAlign>;

  /// The constants of a motion, in the axes (a, b, c) of docs/exact.md: L circles a, and b is the
  /// intermediate axis. A steady spin has an orbit too, with L along a and k = 0.
  struct Orbit {
    elliptic::Jacobi jacobi;
    double m, mc;               ///< Parameter k^2, and 1 - k^2.
    double rate;                ///< lambda = du/dt in 1/s.
    double phase;               ///< u at t = 0.
    double quarter_turns;       ///< Of psi/2, on average, per second.
    Eigen::Vector3d amplitude;  ///< Amplitudes of mu = m/G = (a dn u, b sn u, c cn u).
    /// Maps the quaternion (w, x, y, z) of Rot(e_a, psi) P, eq. (E5), to that of X. Both are
    /// determined up to a factor.
    Matrix4 attitude_from_turn = Matrix4::Zero();
    Eigen::Matrix3d omega_from_mu = Eigen::Matrix3d::Zero();  ///< In rad/s.
  };
  struct Samples;

  void prepare(const FreeBody& body);
  static Orbit steady_orbit(const Eigen::Vector3d& omega);
  static Orbit orbit(double G, const Eigen::Vector3d& mu, const Eigen::Vector3d& I, double D2);
  /// The quaternion of Rot(e_a, psi) P at t = 0, up to a factor.
  static Quaternion turn_at_start(const Orbit& orbit);
  template <class Write>
  void for_each_block(std::span<const double> times, unsigned threads, const Write& write) const;

  Kind kind_ = Kind::steady;
  Sample start_;  ///< At t = 0, where the constants give it up to their rounding only.
  Orbit orbit_;
};

/// Returns attitude number `index` of an array that ExactMotion::at() or exact_many() has written.
/// The array is in row-major order; Eigen's matrices are in column-major order, so that a
/// `Map<Matrix3d>` of it would be the transpose. Throws OutOfRange about "index" where the array
/// has no such attitude.
Eigen::Matrix3d attitude_at(std::span<const double> X, std::size_t index);

/// Takes an exact step of h s, of either sign: returns the body with the attitude and the angular
/// velocity that its motion has at h. This is for simulations whose bodies are pushed between
/// steps; the motion of a body that is left alone is ExactMotion. Each step rounds the state:
/// 100,000 steps near the separatrix drift by 4e-6 where ExactMotion stays exact. Throws OutOfRange
/// about "t" unless h is finite.
FreeBody exact_step(const FreeBody& body, double h);

static_assert(alignof(ExactMotion) == alignof(elliptic::Jacobi),
              "the layout depends on compiler flags");

}  // namespace twrench::motion
