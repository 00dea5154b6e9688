#pragma once

#include <twrench/motion/exact.h>

#include <span>

namespace twrench::motion {

/// Evaluates the exact motion of many bodies at once, from arrays in row-major order and into
/// arrays of the caller. Body axes are principal axes. `inertia` holds the principal moments in g
/// cm^2, n x 3 numbers, or 3 for n bodies alike; `omega` the angular velocities at t = 0 in rad/s,
/// n x 3 numbers. Writes the attitudes at m times (s, of either sign) to `X`, n x m x 3 x 3
/// numbers, and the angular velocities in body axes, rad/s, to `velocities`, n x m x 3 numbers. Up
/// to `threads` threads work; each sample has the bits of ExactMotion::at, however many they are.
///
/// Throws OutOfRange about "inertia[i, j]" unless that is positive and finite, about "omega[i, j]"
/// and "times[i]" unless they are finite; InvalidArgument about the array whose size is wrong, and
/// about "inertia[i]" or "omega[i]" where a body's inverse or momentum is beyond what double
/// precision holds. After an exception the output is unspecified.
void exact_many(std::span<const double> inertia, std::span<const double> omega,
                std::span<const double> times, std::span<double> X, std::span<double> velocities,
                unsigned threads = all_processors);

/// Writes the time of each body's first flip after t = 0 in s to `first`, n numbers: that of
/// ExactMotion::flips, infinite where there is none. The other arguments, and what it throws, are
/// those of exact_many().
void first_flip_times(std::span<const double> inertia, std::span<const double> omega,
                      std::span<double> first, unsigned threads = all_processors);

}  // namespace twrench::motion
