#pragma once

#include <twrench/motion/free_body.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <span>
#include <vector>

namespace twrench::motion {

/// A motion that is known at some times, with a smooth motion between them.
///
/// With X(t) = X_0 exp(hat(u)) between two instants, u is the cubic polynomial in t that gives both
/// attitudes and both angular velocities: the error of the attitude is of order 4 in their
/// distance, that of the angular velocity of order 3. Source: Park and Ravani, Smooth invariant
/// interpolation of rotations, ACM Trans. Graphics 16 (1997), with Hermite's polynomial.
class RecordedMotion {
 public:
  /// The state at one time.
  struct Instant {
    double t;                                       ///< s
    Eigen::Quaternion<double, Eigen::DontAlign> X;  ///< space_from_body, of unit length
    Eigen::Vector3d omega;                          ///< body axes, rad/s
  };

  /// `instants` must be in ascending order of time; the first is moved to t = 0. If two are more
  /// than `longest_step` s apart, nothing is known between them: the body is held in the attitude
  /// of the earlier one. Throws InvalidArgument about "instants" if there are fewer than two.
  RecordedMotion(std::vector<Instant> instants, double longest_step);

  /// The time of the last instant in s.
  double duration() const { return instants_.back().t; }

  const std::vector<Instant>& instants() const { return instants_; }

  /// Returns the state at t in s: before the first instant and after the last one, that of the
  /// instant.
  Sample at(double t) const;

  /// Returns the states at `times` in s.
  std::vector<Sample> samples_at(std::span<const double> times) const;

  /// Upper bounds of |omega| and |omega'| (rad/s, rad/s^2) from `begin` to `end`, without the jumps
  /// at the ends of gaps.
  struct Rates {
    double velocity = 0, acceleration = 0;
  };
  Rates rates_between(double begin, double end) const;

  /// Whether the motion is held anywhere because nothing is known.
  bool has_gaps() const;

  /// Whether nothing is known at t in s.
  bool is_in_gap(double t) const;

  /// Returns the motion through some of the instants, as few as a greedy search finds, among them
  /// both ends of each gap. At the others its attitude differs by at most `angle` rad.
  RecordedMotion thinned(double angle) const;

  /// The greatest time in s between two instants between which the motion is known.
  double longest_step() const { return longest_step_; }

 private:
  /// The motion from one instant to the next: u = s (linear + s (square + s cube)) with s from 0 to
  /// 1.
  struct Piece {
    Sample at(double t) const;

    Eigen::Matrix3d start;
    double begin;  ///< s
    Eigen::Vector3d linear, square, cube;
    double length;  ///< s
  };
  Piece piece_between(std::size_t begin, std::size_t end) const;
  /// Returns whether the piece between two instants meets the attitudes between them.
  bool can_skip(std::size_t begin, std::size_t end, double angle) const;
  /// Returns the last instant up to `limit` before which all can be skipped.
  std::size_t farthest(std::size_t begin, std::size_t limit, double angle) const;
  /// Returns the last instant that is not after t, but not the last of all.
  std::size_t before(double t) const;
  bool is_gap_after(std::size_t instant) const;

  std::vector<Instant> instants_;
  double longest_step_;
};

}  // namespace twrench::motion
