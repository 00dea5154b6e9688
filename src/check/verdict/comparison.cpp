#include "check/verdict/comparison.h"

#include <twrench/math/so3.h>
#include <twrench/motion/diagnostics.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace twrench::check {
namespace {

using recording::Row;

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// |a / b - 1|, or 0 if both are zero.
double relative_difference(double a, double b) { return a == b ? 0 : std::abs(a / b - 1); }

double angle_between(const Vector3d& a, const Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace

Comparison::Comparison(const Reference& reference, bool has_rates, bool has_attitude)
    : reference_(reference),
      exact_(reference.body),
      has_rates_(has_rates),
      has_attitude_(has_attitude),
      L_(reference.frame * reference.body.momentum()),
      flips_(reference) {}

void Comparison::add(std::span<const Row> rows) {
  block_.evaluate(exact_, reference_.start, rows);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const motion::Sample exact{rows[i].t, block_.X(i), block_.omega(i)};
    Row row = rows[i];
    if (!has_rates_) row.omega = reference_.body.inverse() * (row.X.transpose() * L_);
    add_row(row, exact);
  }
}

void Comparison::add_row(const Row& row, const motion::Sample& exact) {
  if (rows_ == 0) {
    first_ = row;
    first_energy_ = motion::energy(reference_.body.inertia(), row.omega);
  }
  ++rows_;
  Span span{row};
  const double rate_error = compare_rates(row, exact, span);
  if (rows_ == 1) first_rate_error_ = span.rate_error;
  if (rows_ > 1) accumulated_ += (row.t - last_time_) * (rate_error + last_rate_error_) / 2;
  last_rate_error_ = rate_error;
  last_time_ = row.t;
  if (has_attitude_) compare_attitude(row, exact, span);
  compare_invariants(row, exact.omega);
  course_.add(span);
  flips_.add(row.t, row.omega);
}

void Comparison::add_to(Sums& sums, double error, double squares, double t) const {
  sums.squares += squares;
  if (rows_ > 1 && error <= sums.max) return;
  sums.max = error;
  sums.at = t;
}

ErrorSize Comparison::size_of(const Sums& sums, double components) const {
  return {sums.max, sums.at, std::sqrt(sums.squares / (components * static_cast<double>(rows_)))};
}

double Comparison::compare_rates(const Row& row, const motion::Sample& exact, Span& span) {
  const Vector3d error = row.omega - exact.omega;
  const Vector3d derivative =
      reference_.body.inverse() * (reference_.body.inertia() * exact.omega).cross(exact.omega);
  largest_rate_ = std::max(largest_rate_, row.omega.cwiseAbs().maxCoeff());
  largest_acceleration_ = std::max(largest_acceleration_, derivative.cwiseAbs().maxCoeff());
  if (!has_rates_) return 0;
  span.rate_error = error.cwiseAbs().maxCoeff();
  add_to(rates_, span.rate_error, error.squaredNorm(), row.t);
  span.rate_differences = rate_table_.add(row.t, error).value_or(DifferenceSums());
  return error.norm();
}

void Comparison::compare_attitude(const Row& row, const motion::Sample& exact, Span& span) {
  const Vector3d error = so3::log(row.X * (reference_.frame * exact.X).transpose());
  const double t = row.t - first_.t;
  span.attitude_error = error.norm();
  span.rodrigues_length = row.rodrigues_length;
  add_to(attitude_, span.attitude_error, error.squaredNorm(), row.t);
  // The rotation vector of an error jumps where it passes half a turn: that is no noise.
  if ((error - last_attitude_error_).norm() > std::numbers::pi) attitude_table_ = {};
  last_attitude_error_ = error;
  span.attitude_differences = attitude_table_.add(row.t, error).value_or(DifferenceSums());
  times_squared_ += t * t;
  times_errors_ += t * error;
  errors_squared_ += error.squaredNorm();
  orthogonality_error_ = std::max(orthogonality_error_, row.orthogonality_error);
}

void Comparison::compare_invariants(const Row& row, const Vector3d& exact_omega) {
  const Matrix3d& inertia = reference_.body.inertia();
  const auto larger = [](double& most, double value) { most = std::max(most, value); };
  const double energy = motion::energy(inertia, row.omega);
  larger(energy_drift_, relative_difference(energy, first_energy_));
  larger(energy_error_, relative_difference(energy, motion::energy(inertia, exact_omega)));
  if (!has_rates_) return;
  const Vector3d momentum = inertia * row.omega, first = inertia * first_.omega;
  larger(momentum_drift_, relative_difference(momentum.norm(), first.norm()));
  larger(momentum_error_, relative_difference(momentum.norm(), (inertia * exact_omega).norm()));
  if (has_attitude_) larger(direction_drift_, angle_between(row.X * momentum, first_.X * first));
}

FrameTurn Comparison::frame_turn() const {
  if (times_squared_ == 0 || errors_squared_ == 0) return {};
  return {times_errors_ / times_squared_,
          times_errors_.squaredNorm() / (times_squared_ * errors_squared_)};
}

}  // namespace twrench::check
