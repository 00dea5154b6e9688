#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

namespace twrench::recording {

/// A sequence of vectors: a row each, for the times in s, ascending.
struct Sequence {
  std::span<const double> times;
  Eigen::MatrixXd values;
};

/// Returns the standard deviation of noise that is independent from row to row, of each of three
/// components; the values may have more, on which the noise has no effect, such as the length of a
/// quaternion. Returns nothing if there are fewer than 20 rows, or if what is not smooth depends on
/// the neighbours: that is no noise. It is estimated from the median of the fourth and sixth
/// divided differences, which remove the smooth part, so a few jumps do not count. Source: More and
/// Wild, Estimating computational noise, SIAM J. Sci. Comput. 33 (2011).
std::optional<double> independent_noise(const Sequence& sequence);

/// Returns the smoothest values whose root mean square distance from the given ones is that of the
/// noise: those with the least sum of squared third divided differences. Source: Reinsch, Smoothing
/// by spline functions, Numer. Math. 10 (1967), with Whittaker's differences instead of integrals.
Eigen::MatrixXd smoothed(const Sequence& sequence, double noise);

}  // namespace twrench::recording
