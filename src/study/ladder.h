#pragma once

#include <optional>
#include <span>
#include <vector>

namespace twrench {

/// Step lengths, s, from a coarse one to a fine one by halves, for a motion of `duration` seconds
/// at `speed` rad/s: from 0.2 rad or less a step, a round number of seconds, down to what takes
/// 200,000 steps, eight at most.
std::vector<double> step_ladder(double duration, double speed);

/// A round number of seconds after which the body has turned by about 10 rad; the duration, where
/// that is shorter.
double early_time(double duration, double speed);

/// Tolerances from 1e-4 to 1e-12 by tenths.
std::vector<double> tolerance_ladder();

/// The middle one of the values, or the mean of the two that are. `values` is not empty.
double median(std::vector<double> values);

struct Point {
  double x, y;  ///< positive
};

/// The exponent p of y = c x^p through the points: the median of the slopes of all pairs in
/// logarithms (Theil and Sen), which a stray point does not move. Nothing for fewer than two.
std::optional<double> fitted_exponent(std::span<const Point> points);

}  // namespace twrench
