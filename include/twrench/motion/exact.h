#pragma once

#include <twrench/motion/free_body.h>

#include <Eigen/Core>
#include <memory>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

namespace twrench::motion {

/// As a number of threads: one per processor.
inline constexpr unsigned all_processors = 0;

/// The constants of an ExactMotion.
class ExactSolution;

/// The motion of a free rigid body in closed form: the solution of eq. (19)-(20) at any t and at a
/// cost independent of t. docs/exact.md derives it and numbers its equations from
/// (E1).
///
/// It covers every positive definite inertia and every momentum: both sides of the separatrix and
/// the separatrix itself, symmetric bodies, the sphere, spin about a principal axis, and rest. The
/// error of X grows as eps |omega| t, and beyond that only as fast as the motion itself amplifies a
/// relative error of eps in the initial velocity. Momentum components below 1e-145 |L| may be
/// treated as zero.
///
/// Copies share their constants. Moving an object copies it, so that no motion is ever empty.
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

  /// Returns whether the motion of a body has a closed form: not with energy loss, and with a wheel
  /// only if the wheel is along the axis of a symmetric body.
  static bool covers(const FreeBody& body);

  /// Prepares the constants of the motion. Throws InvalidArgument about "method exact" if there is
  /// no closed form.
  explicit ExactMotion(const FreeBody& body);
  /// Copies it.
  ExactMotion(const ExactMotion&) = default;
  /// Copies it.
  ExactMotion& operator=(const ExactMotion&) = default;
  ~ExactMotion() = default;

  /// Returns the sample at time t in s, of either sign. Throws OutOfRange unless t is finite.
  Sample at(double t) const;

  /// Evaluates the motion at n times in s, of either sign and in any order, in vector registers and
  /// on up to `threads` threads. Writes the attitudes to `X`, n x 3 x 3 numbers in row-major order
  /// (see attitude_at()), and the angular velocities in body axes, rad/s, to `omega`, n x 3
  /// numbers. If an array is empty, its quantity is not written. Each sample has the same bits as
  /// at(t), whatever the other times and the number of threads. Throws OutOfRange about "times[i]"
  /// unless it is finite, and InvalidArgument about "X" or "omega" if its size is wrong, before
  /// anything is written.
  void at(std::span<const double> times, std::span<double> X, std::span<double> omega,
          unsigned threads = all_processors) const;
  /// Does the same, and returns samples in the order of `times`.
  std::vector<Sample> at(std::span<const double> times, unsigned threads = all_processors) const;

  /// Returns the kind of the motion.
  Kind kind() const;

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
    /// The complementary parameter 1 - k^2 of these functions, from 0 (the separatrix) to below 1.
    double mc;

    /// The least swing in rad of a body that turns over: the intermediate axis comes within 30
    /// degrees of L and of the opposite direction. With less, as of a tumbling asteroid, the body
    /// wobbles about an outer axis.
    static constexpr double least_swing = 2 * std::numbers::pi / 3;

    /// Returns whether the body turns over rather than wobbles.
    bool turns_over() const { return swing >= least_swing; }
  };
  /// Returns the flips; nothing for steady motion or for a body with two equal moments, to 1e-4,
  /// which has no intermediate axis.
  std::optional<Flips> flips() const;

  /// Returns the period of the nutation in s: the time in which the momentum traverses its path in
  /// the body frame once. Infinite on the separatrix; nothing for steady motion.
  std::optional<double> nutation_period() const;

  /// The rotation about L in one period of the nutation: X(T) X(0)^T = Rot(L/|L|, total), without
  /// mod 2 pi (Montgomery, How much does the rigid body rotate?, Amer. J. Phys. 59 (1991);
  /// docs/theory.md).
  struct Phase {
    double period;   ///< T in s: that of nutation_period().
    double total;    ///< In rad.
    double dynamic;  ///< The integral of omega . L/|L| in rad: 2 E T / |L| for a rigid body.

    /// Returns the part that depends on the path of the momentum alone: minus area().
    double geometric() const { return total - dynamic; }
    /// Returns the area on the unit sphere that is enclosed by the path of the momentum's direction
    /// in the body, on the side of the axis that it circles. Negative if the path runs clockwise as
    /// seen from outside, as it does about the axis of least moment.
    double area() const { return dynamic - total; }
  };
  /// Returns the phase; nothing for steady motion or on the separatrix.
  std::optional<Phase> phase() const;

  /// Returns the times in s of all flips with 0 < t <= t_end, ascending. Throws OutOfRange unless
  /// t_end is finite, and MotionError if there are more than 10^7.
  std::vector<double> flip_times(double t_end) const;

 private:
  std::shared_ptr<const ExactSolution> solution_;
};

/// Returns attitude number `index` of an array written by ExactMotion::at() or exact_many(). The
/// array is in row-major order and Eigen's matrices are in column-major order, so a `Map<Matrix3d>`
/// of it would be the transpose. Throws OutOfRange about "index" if the array has no such attitude.
Eigen::Matrix3d attitude_at(std::span<const double> X, std::size_t index);

/// Takes an exact step of h s, of either sign: returns the body with the attitude and the angular
/// velocity of its motion at time h. It is meant for simulations that push bodies between steps;
/// for an undisturbed body use ExactMotion. Each step rounds the state, and near the separatrix the
/// motion amplifies this error (docs/library.md, "Restarts"). Throws OutOfRange about "t" unless h
/// is finite.
FreeBody exact_step(const FreeBody& body, double h);

}  // namespace twrench::motion
