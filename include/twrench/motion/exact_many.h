#pragma once

#include <twrench/motion/exact.h>

#include <span>

namespace twrench::motion {

/// Bodies as the caller's arrays in row-major order. Body axes are principal axes, and X(0) = Id.
struct ManyBodies {
  /// Principal moments in g cm^2, n x 3 numbers, or 3 that apply to all n bodies.
  std::span<const double> inertia;
  /// Angular velocities at t = 0 in rad/s, n x 3 numbers.
  std::span<const double> omega;
};

/// The caller's arrays for the motions of n bodies at m times, in row-major order. If an array is
/// empty, its quantity is not written.
struct ManySamples {
  /// Attitudes, n x m x 3 x 3 numbers (see attitude_at()).
  std::span<double> X;
  /// Angular velocities in body axes, rad/s, n x m x 3 numbers.
  std::span<double> omega;
};

/// Evaluates the exact motion of many bodies at once, at m times (s, of either sign), on up to
/// `threads` threads. Each sample has the same bits as ExactMotion::at(), whatever the number of
/// threads.
///
/// Throws OutOfRange about "inertia[i, j]" unless it is positive and finite, and about "omega[i,
/// j]" and "times[i]" unless they are finite; InvalidArgument about "inertia", "omega", "samples.X"
/// or "samples.omega" if the size is wrong, and about "inertia[i]" or "omega[i]" if a body's
/// inverse inertia or momentum exceeds the range of a double. After an exception the output is
/// unspecified.
void exact_many(const ManyBodies& bodies, std::span<const double> times, const ManySamples& samples,
                unsigned threads = all_processors);

/// Writes the time in s of each body's first flip after t = 0 to `first`, n numbers, as
/// ExactMotion::flips() gives it; infinite if there is none. Throws about `bodies` as exact_many()
/// does, and InvalidArgument about "first" if its size is wrong.
void first_flip_times(const ManyBodies& bodies, std::span<double> first,
                      unsigned threads = all_processors);

}  // namespace twrench::motion
