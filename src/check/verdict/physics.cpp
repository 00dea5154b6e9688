#include "check/verdict/physics.h"

#include <twrench/math/so3.h>
#include <twrench/motion/exact.h>

#include <algorithm>
#include <functional>
#include <vector>

#include "check/verdict/fit.h"
#include "study/ladder.h"

namespace twrench::check {
namespace {

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

using Measure = Miss (*)(const Matrix3d&, std::span<const Row>, std::size_t, std::size_t);

/// The least ratio of the median miss to the median change over strides of 1, 2, 4 ... rows. The
/// measure uses rows up to `reach` strides ahead of at most `most` rows for each stride. Returns
/// nothing if the change is below `least_change` at all strides.
std::optional<double> least_ratio(const Matrix3d& inertia, std::span<const Row> rows,
                                  Measure measure, std::size_t reach, double least_change,
                                  std::size_t most) {
  std::optional<double> least;
  for (std::size_t stride = 1; stride * reach < rows.size(); stride *= 2) {
    std::vector<double> misses, changes;
    const std::size_t starts = rows.size() - stride * reach;
    for (std::size_t i = 0; i < starts; i += (starts + most - 1) / most) {
      const Miss here = measure(inertia, rows, i, stride);
      misses.push_back(here.miss);
      changes.push_back(here.change);
    }
    constexpr std::size_t enough = 4;
    if (stride > 1 && misses.size() < enough) break;
    const double change = study::median(std::move(changes));
    if (!(change > least_change)) continue;
    const double ratio = study::median(std::move(misses)) / change;
    least = std::min(least.value_or(ratio), ratio);
  }
  return least;
}

/// Smaller changes, relative to |omega| or in rad, are not informative.
constexpr double too_small = 1e-6;

double largest_speed(std::span<const Row> rows) {
  double speed = 0;
  for (const Row& row : rows) speed = std::max(speed, row.omega.norm());
  return speed;
}

}  // namespace

std::optional<double> Misfit::worst() const {
  return rates && attitude ? std::max(*rates, *attitude) : rates ? rates : attitude;
}

bool Misfit::fits() const {
  constexpr double follows = 0.2;  // a first-order method at 0.2 rad per row
  return worst().value_or(0) < follows;
}

std::optional<double> misfit_of_rates(const Matrix3d& inertia, std::span<const Row> rows,
                                      std::size_t most_pairs) {
  return least_ratio(inertia, rows, miss_of_rates, 1, too_small * largest_speed(rows), most_pairs);
}

std::optional<double> misfit_of_attitude(const Matrix3d& inertia, std::span<const Row> rows,
                                         bool has_rates, std::size_t most_pairs) {
  if (has_rates) return least_ratio(inertia, rows, miss_of_attitude, 1, too_small, most_pairs);
  return least_ratio(inertia, rows, miss_of_attitude_alone, 2, too_small, most_pairs);
}

Misfit misfit(const Matrix3d& inertia, std::span<const Row> rows, bool has_rates,
              bool has_attitude) {
  Misfit result;
  if (has_rates) {
    result.rates = misfit_of_rates(inertia, rows, rows.size());
  }
  if (has_attitude) result.attitude = misfit_of_attitude(inertia, rows, has_rates, rows.size());
  return result;
}

}  // namespace twrench::check
