#include "recording/motion_of_rows.h"

#include <fmt/format.h>
#include <twrench/base/error.h>
#include <twrench/math/so3.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "recording/smoothing.h"

namespace twrench::recording {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using Instant = motion::RecordedMotion::Instant;

constexpr std::size_t most_in_window = 7;

/// The rotation nearest to a matrix that is nearly one, by Newton's iteration for the polar
/// decomposition. Source: Higham, Computing the polar decomposition, SIAM J. Sci. Stat. Comput. 7
/// (1986).
Quaterniond nearest_rotation(Eigen::Matrix3d X) {
  constexpr int most = 20;  // three suffice for the errors of usual integrators
  for (int i = 0; i < most; ++i) {
    const Eigen::Matrix3d next = 0.5 * (X + X.inverse().transpose());
    if ((next - X).norm() < 1e-15) break;
    X = next;
  }
  return Quaterniond(X).normalized();
}

/// The rotation vector from one attitude to another, in the axes of the first.
Vector3d turn_between(const Instant& from, const Instant& to) {
  return so3::log((Quaterniond(from.X).conjugate() * Quaterniond(to.X)).toRotationMatrix());
}

/// The index of the first of `count` rows around row i of `size`: as many before as after it where
/// possible.
std::size_t window_start(std::size_t i, std::size_t count, std::size_t size) {
  const std::size_t before = std::min(i, count / 2);
  return std::min(i - before, size - count);
}

/// Sets the rates to the derivatives of the attitudes. `widest` is the largest turn between
/// neighbours in rad.
void derive_rates(std::span<Instant> rows, double widest) {
  // Rotation vectors between the ends of a window must stay below half a turn.
  constexpr double farthest = 2.8;
  const double reach = std::min(farthest / widest, double(most_in_window - 1));
  const std::size_t count = std::min(static_cast<std::size_t>(reach) + 1, rows.size());
  for (std::size_t i = 0; count > 1 && i < rows.size(); ++i) {
    const std::size_t first = window_start(i, count, rows.size()), self = i - first;
    const std::span<const Instant> window = rows.subspan(first, count);
    std::vector<double> times;
    for (const Instant& instant : window) times.push_back(instant.t - rows[i].t);
    const std::vector<double> weights = derivative_weights(times);
    Vector3d rate = Vector3d::Zero();
    for (std::size_t k = 0; k < count; ++k) {
      if (k != self) rate += weights[k] * turn_between(window[self], window[k]);
    }
    rows[i].omega = rate;
  }
}

/// The rate at a time between rows i and i + 1, from the cubic through four rows.
Vector3d rate_at(std::span<const Instant> rows, std::size_t i, double t) {
  const std::size_t count = std::min<std::size_t>(4, rows.size());
  const std::size_t first = std::min(i > 0 ? i - 1 : 0, rows.size() - count);
  Vector3d rate = Vector3d::Zero();
  for (std::size_t k = first; k < first + count; ++k) {
    double weight = 1;
    for (std::size_t other = first; other < first + count; ++other) {
      if (other != k) weight *= (t - rows[other].t) / (rows[k].t - rows[other].t);
    }
    rate += weight * rows[k].omega;
  }
  return rate;
}

/// Sets the attitudes to the integrals of the rates, from that of the first row. For X' = X hat(w)
/// the commutator of Magnus' series is w(t1) x w(t2).
void integrate_rates(std::span<Instant> rows) {
  const double offset = std::sqrt(3.0) / 6;
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
    const double length = rows[i + 1].t - rows[i].t, middle = rows[i].t + length / 2;
    const Vector3d early = rate_at(rows, i, middle - offset * length);
    const Vector3d late = rate_at(rows, i, middle + offset * length);
    const Vector3d u =
        length / 2 * (early + late) + std::sqrt(3.0) / 12 * length * length * early.cross(late);
    const double angle = u.norm();
    const Quaterniond turn(angle > 0 ? Eigen::AngleAxisd(angle, u / angle)
                                     : Eigen::AngleAxisd::Identity());
    rows[i + 1].X = (Quaterniond(rows[i].X) * turn).normalized();
  }
}

/// The angle by which the integral over every second row misses that over all of them, rad. For
/// smooth rates it is some 16 times the error of the latter, and for noisy ones about that error.
double drift_of(std::span<const Instant> rows) {
  std::vector<Instant> every_second;
  for (std::size_t i = 0; i < rows.size(); i += 2) every_second.push_back(rows[i]);
  integrate_rates(every_second);
  return turn_between(rows[2 * (every_second.size() - 1)], every_second.back()).norm();
}

double usual_step(std::span<const Instant> rows) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < rows.size(); ++i) steps.push_back(rows[i].t - rows[i - 1].t);
  const auto middle = steps.begin() + std::ssize(steps) / 2;
  std::ranges::nth_element(steps, middle);
  return *middle;
}

/// Divides rows where more than `longest_step` s lie between two.
std::vector<std::span<Instant>> without_gaps(std::span<Instant> rows, double longest_step) {
  std::vector<std::span<Instant>> parts;
  std::size_t start = 0;
  for (std::size_t i = 1; i <= rows.size(); ++i) {
    if (i < rows.size() && rows[i].t - rows[i - 1].t <= longest_step) continue;
    parts.push_back(rows.subspan(start, i - start));
    start = i;
  }
  return parts;
}

InvalidArgument ambiguous_turn(const Recording& recording, double angle, double t) {
  return {recording.name(),
          fmt::format("the body turns by {:.3g} degrees between two rows, {:.6g} s after the first "
                      "row, so its way is ambiguous",
                      angle * 180 / std::numbers::pi, t),
          "record more rows a second, or check the units"};
}

/// The largest turn between neighbours in rad, by their attitudes or their rates.
double widest_turn(const Recording& recording, std::span<const Instant> rows, bool has_rates) {
  // Attitudes alone say nothing about whole turns; below this there is no doubt.
  const double most = has_rates ? std::numbers::pi : 2.5;
  double widest = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const Instant &before = rows[i - 1], &after = rows[i];
    const double turn =
        has_rates ? (after.t - before.t) * std::max(before.omega.norm(), after.omega.norm())
                  : turn_between(before, after).norm();
    if (turn > most) throw ambiguous_turn(recording, turn, before.t);
    widest = std::max(widest, turn);
  }
  return widest;
}

/// The times of rows, which a Sequence refers to.
std::vector<double> times_of(std::span<const Instant> rows) {
  std::vector<double> times;
  for (const Instant& row : rows) times.push_back(row.t);
  return times;
}

/// The quaternions of rows, without jumps from one to its opposite. Their distances are half the
/// angles between the attitudes.
Eigen::MatrixXd quaternions_of(std::span<const Instant> rows) {
  Eigen::MatrixXd values(std::ssize(rows), 4);
  for (Eigen::Index i = 0; i < values.rows(); ++i) {
    values.row(i) = rows[static_cast<std::size_t>(i)].X.coeffs();
    if (i > 0 && values.row(i).dot(values.row(i - 1)) < 0) values.row(i) *= -1;
  }
  return values;
}

Eigen::MatrixXd rates_of(std::span<const Instant> rows) {
  Eigen::MatrixXd values(std::ssize(rows), 3);
  for (Eigen::Index i = 0; i < values.rows(); ++i) {
    values.row(i) = rows[static_cast<std::size_t>(i)].omega;
  }
  return values;
}

/// Measures the noise in the middle of the longest part.
RowNoise noise_of(std::span<const std::span<Instant>> parts, bool has_attitude, bool has_rates) {
  constexpr std::size_t enough = 20'000;
  const std::span<const Instant> longest =
      *std::ranges::max_element(parts, {}, &std::span<Instant>::size);
  const std::size_t count = std::min(enough, longest.size());
  const auto middle = longest.subspan((longest.size() - count) / 2, count);
  const std::vector<double> times = times_of(middle);
  RowNoise noise;
  if (has_rates) noise.rates = independent_noise({times, rates_of(middle)});
  if (has_attitude) noise.attitude = independent_noise({times, quaternions_of(middle)});
  if (noise.attitude) *noise.attitude *= 2;
  return noise;
}

/// Replaces the rows between two gaps by smoother ones.
void smooth(std::span<Instant> rows, const RowNoise& noise) {
  constexpr std::size_t fewest = 8;  // fewer rows do not distinguish the noise from the motion
  if (rows.size() < fewest) return;
  const std::vector<double> times = times_of(rows);
  if (noise.attitude) {
    const Eigen::MatrixXd values = smoothed({times, quaternions_of(rows)}, *noise.attitude / 2);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows[i].X.coeffs() = values.row(static_cast<Eigen::Index>(i)).normalized();
    }
  }
  if (noise.rates) {
    const Eigen::MatrixXd values = smoothed({times, rates_of(rows)}, *noise.rates);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows[i].omega = values.row(static_cast<Eigen::Index>(i));
    }
  }
}

}  // namespace

MotionOfRows motion_of_rows(const Recording& recording, const Convention& convention,
                            const Quaterniond& start, Smoothing smoothing) {
  RowReader reader = recording.rows(convention);
  const bool has_rates = reader.has_rates();
  const bool has_attitude = reader.attitude() != AttitudeForm::none;
  std::vector<Instant> rows;
  for (Row row; reader.next(row);) {
    const Quaterniond X = has_attitude ? nearest_rotation(row.X) : start;
    rows.push_back({row.t, X, row.omega});
  }
  if (rows.size() < 2) {
    throw InvalidArgument(recording.name(),
                          fmt::format("{} row{} to show, but a motion needs two", rows.size(),
                                      rows.size() == 1 ? "" : "s"),
                          "give other times, or a longer recording");
  }
  constexpr double rounding = 1 + 1e-6;
  const double longest_step = 4 * usual_step(rows) * rounding;
  const auto parts = without_gaps(rows, longest_step);
  const RowNoise noise = noise_of(parts, has_attitude, has_rates);
  double drift = 0;
  for (const std::span<Instant> part : parts) {
    const double widest = widest_turn(recording, part, has_rates);
    if (!has_attitude) {
      if (part.data() != rows.data()) part.front().X = (part.data() - 1)->X;  // held in the gap
      integrate_rates(part);
      drift += drift_of(part);
    }
    switch (smoothing) {
      case Smoothing::none:
        break;
      case Smoothing::within_noise:
        smooth(part, noise);
        if (!has_attitude) integrate_rates(part);  // the drift remains that of the noise
        break;
    }
    if (!has_rates) derive_rates(part, widest);
  }
  return {.motion = {std::move(rows), longest_step},
          .clock_start = reader.first_time(),
          .has_rates = has_rates,
          .has_attitude = has_attitude,
          .gaps = parts.size() - 1,
          .drift = drift,
          .noise = noise,
          .left_out = recording.left_out()};
}

}  // namespace twrench::recording
