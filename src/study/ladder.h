#pragma once

#include <optional>
#include <span>
#include <vector>

namespace twrench::study {

/// Returns step sizes in s from coarse to fine, each half the previous one, for a motion of
/// `duration` seconds at `speed` rad/s: at most eight, from a round number of seconds with about
/// 0.2 rad per step or less, down to at most 200,000 steps.
std::vector<double> step_ladder(double duration, double speed);

/// Returns a round number of seconds in which the body rotates by about 10 rad, or the duration if
/// that is shorter.
double early_time(double duration, double speed);

/// Returns tolerances from 1e-4 to 1e-12, each a tenth of the previous one.
std::vector<double> tolerance_ladder();

/// Returns the median of the values, which must not be empty; the mean of the middle two if their
/// number is even.
double median(std::vector<double> values);

/// A point of a power law.
struct PowerLawPoint {
  double x;  ///< Positive.
  double y;  ///< Positive.
};

/// Returns the exponent p of y = c x^p through the points: the median of the slopes of all pairs on
/// logarithmic scales (Theil and Sen), which is robust against outliers. Nothing for fewer than two
/// points.
std::optional<double> fitted_exponent(std::span<const PowerLawPoint> points);

}  // namespace twrench::study
