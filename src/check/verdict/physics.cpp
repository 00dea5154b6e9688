#include "check/verdict/physics.h"

#include <twrench/math/so3.h>
#include <twrench/motion/exact.h>

#include <algorithm>
#include <numbers>
#include <utility>
#include <vector>

#include "check/verdict/fit.h"
#include "study/ladder.h"

namespace twrench::check {
namespace {

using recording::Row;

using Eigen::Matrix3d;
using Eigen::Vector3d;

double angle(const Matrix3d& R) { return so3::log(R).norm(); }

/// The miss of a prediction, and the change in the rows or in the prediction, whichever is larger:
/// a change that should happen but does not is a miss, too.
struct Miss {
  double miss, change;
};

/// The exact motion from one row to a later one.
motion::Sample predicted(const Matrix3d& inertia, const Vector3d& omega, const Row& from,
                         const Row& to) {
  return motion::ExactMotion({inertia, omega}).at(to.t - from.t);
}

Miss miss_of_rates(const Matrix3d& inertia, std::span<const Row> rows, std::size_t i,
                   std::size_t stride) {
  const Row &from = rows[i], &to = rows[i + stride];
  const Vector3d expected = predicted(inertia, from.omega, from, to).omega;
  return {(expected - to.omega).norm(),
          std::max((to.omega - from.omega).norm(), (expected - from.omega).norm())};
}

Miss miss_of_attitude(const Matrix3d& inertia, std::span<const Row> rows, std::size_t i,
                      std::size_t stride) {
  const Row &from = rows[i], &to = rows[i + stride];
  const Matrix3d turn = from.X.transpose() * to.X;
  const Matrix3d expected = predicted(inertia, from.omega, from, to).X;
  return {angle(expected.transpose() * turn), std::max(angle(turn), angle(expected))};
}

/// Without rates: the velocity that leads to the second row must lead on to the third.
Miss miss_of_attitude_alone(const Matrix3d& inertia, std::span<const Row> rows, std::size_t i,
                            std::size_t stride) {
  const Row &first = rows[i], &second = rows[i + stride], &third = rows[i + 2 * stride];
  const Vector3d omega = omega_between(inertia, first, second);
  const Matrix3d turn = first.X.transpose() * second.X, on = second.X.transpose() * third.X;
  const Matrix3d expected = turn.transpose() * predicted(inertia, omega, first, third).X;
  return {angle(expected.transpose() * on),
          std::max(angle(turn.transpose() * on), angle(turn.transpose() * expected))};
}

/// A test of the rates or of the attitude against the physics.
struct Measure {
  Miss (*miss)(const Matrix3d& inertia, std::span<const Row> rows, std::size_t i,
               std::size_t stride);
  double (*change)(const Row& from, const Row& to);
  std::size_t reach;    ///< strides from the first row to the last one that is used
  double least_change;  ///< smaller ones are not informative
  double clear_change;  ///< larger than what digits and noise change
};

double change_of_rates(const Row& from, const Row& to) { return (to.omega - from.omega).norm(); }

double change_of_attitude(const Row& from, const Row& to) {
  return angle(from.X.transpose() * to.X);
}

/// The number of rows with all rows of a test after them.
std::size_t starts_of(std::span<const Row> rows, const Measure& measure, std::size_t stride) {
  return rows.size() - stride * measure.reach;
}

/// The ratio of the median miss to the median change at a stride, from at most `most` pairs.
/// Nothing if the change is too small.
std::optional<double> ratio(const Matrix3d& inertia, std::span<const Row> rows,
                            const Measure& measure, std::size_t stride, std::size_t most) {
  std::vector<double> misses, changes;
  const std::size_t starts = starts_of(rows, measure, stride);
  for (std::size_t i = 0; i < starts; i += (starts + most - 1) / most) {
    const Miss here = measure.miss(inertia, rows, i, stride);
    misses.push_back(here.miss);
    changes.push_back(here.change);
  }
  const double change = study::median(std::move(changes));
  if (!(change > measure.least_change)) return {};
  return study::median(std::move(misses)) / change;
}

/// Strides of 1, 2, 4 ... rows at which there are at least a few pairs.
std::vector<std::size_t> strides_of(std::span<const Row> rows, const Measure& measure) {
  constexpr std::size_t enough = 4;
  std::vector<std::size_t> strides;
  for (std::size_t stride = 1; stride * measure.reach < rows.size(); stride *= 2) {
    if (stride > 1 && starts_of(rows, measure, stride) < enough) break;
    strides.push_back(stride);
  }
  return strides;
}

double largest_speed(std::span<const Row> rows) {
  double speed = 0;
  for (const Row& row : rows) speed = std::max(speed, row.omega.norm());
  return speed;
}

/// Whether the body makes more than a turn from row to row.
bool are_far_apart(std::span<const Row> rows) {
  const double step = (rows.back().t - rows.front().t) / static_cast<double>(rows.size() - 1);
  return largest_speed(rows) * step > 2 * std::numbers::pi;
}

/// The least ratio over all strides. Motions are nearly periodic, so rows that are far apart fit by
/// chance at a single stride, and the largest ratio of three counts.
std::optional<double> typical_ratio(const Matrix3d& inertia, std::span<const Row> rows,
                                    const Measure& measure) {
  constexpr std::size_t enough_for_medians = 32, too_many_for_chance = 3;
  std::vector<double> ratios;
  for (const std::size_t stride : strides_of(rows, measure)) {
    const auto here = ratio(inertia, rows, measure, stride, enough_for_medians);
    if (here) ratios.push_back(*here);
  }
  if (ratios.empty()) return {};
  if (!are_far_apart(rows)) return std::ranges::min(ratios);
  return std::ranges::max(std::span(ratios).first(std::min(ratios.size(), too_many_for_chance)));
}

/// The ratio at the shortest stride with a clear change, or else at that with the largest change.
std::optional<double> quick_ratio(const Matrix3d& inertia, std::span<const Row> rows,
                                  const Measure& measure) {
  constexpr std::size_t few = 8;
  std::size_t best = 0;
  double largest = 0;
  for (const std::size_t stride : strides_of(rows, measure)) {
    std::vector<double> changes;
    const std::size_t starts = starts_of(rows, measure, stride);
    for (std::size_t i = 0; i < starts; i += (starts + few - 1) / few) {
      changes.push_back(measure.change(rows[i], rows[i + stride]));
    }
    const double change = study::median(std::move(changes));
    if (change > largest) {
      best = stride;
      largest = change;
    }
    if (change > measure.clear_change) break;
  }
  if (best == 0) return {};
  return ratio(inertia, rows, measure, best, few);
}

/// Smaller changes, relative to |omega| or in rad, are not informative.
constexpr double too_small = 1e-6;

Measure measure_of_rates(std::span<const Row> rows) {
  constexpr double clear = 0.3;
  const double speed = largest_speed(rows);
  return {miss_of_rates, change_of_rates, 1, too_small * speed, clear * speed};
}

Measure measure_of_attitude(bool has_rates) {
  constexpr double clear = 0.5;  // rad
  if (has_rates) return {miss_of_attitude, change_of_attitude, 1, too_small, clear};
  return {miss_of_attitude_alone, change_of_attitude, 2, too_small, clear};
}

}  // namespace

std::optional<double> Misfit::worst() const {
  return rates && attitude ? std::max(*rates, *attitude) : rates ? rates : attitude;
}

bool Misfit::fits() const {
  constexpr double follows = 0.2;  // a first-order method at 0.2 rad per row
  return worst().value_or(0) < follows;
}

Misfit misfit(const Matrix3d& inertia, std::span<const Row> rows, bool has_rates,
              bool has_attitude) {
  Misfit result;
  if (has_rates) result.rates = typical_ratio(inertia, rows, measure_of_rates(rows));
  if (has_attitude) result.attitude = typical_ratio(inertia, rows, measure_of_attitude(has_rates));
  return result;
}

std::optional<double> quick_misfit_of_rates(const Matrix3d& inertia, std::span<const Row> rows) {
  return quick_ratio(inertia, rows, measure_of_rates(rows));
}

std::optional<double> quick_misfit_of_attitude(const Matrix3d& inertia, std::span<const Row> rows,
                                               bool has_rates) {
  return quick_ratio(inertia, rows, measure_of_attitude(has_rates));
}

}  // namespace twrench::check
