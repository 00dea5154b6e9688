#include "interchange/key_times.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "interchange/error.h"

namespace twrench::interchange {
namespace {

constexpr std::size_t most_keys = 5'000'000;

/// Each of the four components of a key is off by at most 2^-25, and its angle by at most twice the
/// length of that error, 1.2e-7 rad. A player that computes in float32 adds a few such errors.
constexpr double rounding = 5e-7;

constexpr double longest_turn = 1;  // rad between two keys, within which the bounds below hold

/// Returns a bound for the angle in rad between a path and its interpolation over an interval of
/// `length` s.
///
/// Let two paths have the same ends on a space of curvature at most 1. One is a geodesic, and
/// neither is faster than v. Their distance r satisfies r'' + v^2 r >= -a, so it is at most
/// (sec(vh/2) - 1) a/v^2, which is at most the first term. Normalised linear interpolation runs
/// along the same geodesic, ahead of or behind the spherical one by at most the second term.
double interpolation_error(const RateBounds& rates, double length) {
  const double turn = rates.velocity * length;
  return rates.acceleration * length * length / 8 * (1 + turn * turn / 8) +
         0.0042 * turn * turn * turn;
}

/// Returns the longest interval in s whose error is at most `allowed`, but not more than `most`.
double longest_interval(const RateBounds& rates, double allowed, double most) {
  const double quickest =
      rates.velocity * most <= longest_turn ? most : longest_turn / rates.velocity;
  if (interpolation_error(rates, quickest) <= allowed) return quickest;
  double within = 0, beyond = quickest;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (within + beyond);
    (interpolation_error(rates, middle) <= allowed ? within : beyond) = middle;
  }
  return within;
}

/// Returns the least float32 number that is not less than `time`.
float rounded_up(double time) {
  const auto nearest = static_cast<float>(time);
  return nearest < time ? std::nextafter(nearest, std::numeric_limits<float>::infinity()) : nearest;
}

void require_representable(float from, float to, double length, double max_angle,
                           std::string_view unit) {
  if (from < to) return;
  const double spacing = to - std::nextafter(to, 0.0F);
  throw AccuracyError(
      "export",
      fmt::format("at {:.6g} {} the times of keys, which are float32 numbers, are {:.2g} {} "
                  "apart, but only keys {:.2g} {} apart keep within {:.2g} rad",
                  to, unit, spacing, unit, length, unit, max_angle));
}

}  // namespace

// Goes from the end to the start, because float32 times are coarsest at the end: if the bound
// cannot be kept there, this is found at once.
std::vector<float> key_times(double end, double max_angle,
                             const std::function<RateBounds(double begin, double end)>& bounds,
                             std::string_view unit) {
  if (!(max_angle >= least_max_angle)) {
    throw OutOfRange("max_angle",
                     fmt::format("is {} rad, but must be at least {}: keys are float32 numbers",
                                 max_angle, least_max_angle),
                     {max_angle, least_max_angle, std::numeric_limits<double>::infinity()});
  }
  const double allowed = max_angle - rounding;
  std::vector<float> times{static_cast<float>(end)};
  double length = longest_interval(bounds(times[0], times[0]), allowed, times[0]);
  while (times.back() > 0) {
    const float to = times.back();
    constexpr double growth = 1.25;
    length = std::min<double>(growth * length, to);
    RateBounds rates = bounds(to - length, to);
    while (std::isinf(rates.velocity) && rounded_up(to - length) < to) {
      length /= 2;
      rates = bounds(to - length, to);
    }
    length = longest_interval(rates, allowed, length);
    const float from = rounded_up(to - length);
    require_representable(from, to, length, max_angle, unit);
    times.push_back(from);
    if (times.size() > most_keys) {
      throw AccuracyError("export", fmt::format("more than {} keys would be needed to keep within "
                                                "{:.2g} rad for {:.6g} {}",
                                                most_keys, max_angle, end, unit));
    }
  }
  std::ranges::reverse(times);
  return times;
}

}  // namespace twrench::interchange
