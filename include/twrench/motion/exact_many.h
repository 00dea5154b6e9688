#pragma once

#include <twrench/motion/exact.h>

#include <span>

namespace twrench::motion {

/// Bodies as arrays of the caller in row-major order. Body axes are principal axes, and X(0) = Id.
struct ManyBodies {
  /// Principal moments in g cm^2, n x 3 numbers, or 3 for n bodies alike.
  std::span<const double> inertia;
  /// Angular velocities at t = 0 in rad/s, n x 3 numbers.
  std::span<const double> omega;
};

/// Arrays of the caller for the motions of n bodies at m times, in row-major order. An empty
/// array leaves its quantity out.
struct ManySamples {
  /// Attitudes, n x m x 3 x 3 numbers (see attitude_at()).
  std::span<double> X;
  /// Angular velocities in body axes, rad/s, n x m x 3 numbers.
  std::span<double> omega;
};

/// Evaluates the exact motion of many bodies at once, at m times (s, of either sign). Up to
/// `threads` threads work; each sample has the bits of ExactMotion::at(), however many they are.
///
/// Throws OutOfRange about "inertia[i, j]" unless that is positive and finite, about "omega[i, j]"
/// and "times[i]" unless they are finite; InvalidArgument about "inertia", "omega", "samples.X" or
/// "samples.omega" where the size is wrong, and about "inertia[i]" or "omega[i]" where a body's
/// inverse or momentum is beyond what double precision holds. After an exception the output is
/// unspecified.
void exact_many(const ManyBodies& bodies, std::span<const double> times, const ManySamples& samples,
                unsigned threads = all_processors);

/// Writes the time of each body's first flip after t = 0 in s to `first`, n numbers: that of
/// ExactMotion::flips(), infinite where there is none. It throws about `bodies` as exact_many(),
/// and InvalidArgument about "first" where the size is wrong.
void first_flip_times(const ManyBodies& bodies, std::span<double> first,
                      unsigned threads = all_processors);

}  // namespace twrench::motion
