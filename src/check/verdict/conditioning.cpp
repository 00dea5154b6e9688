#include "check/verdict/conditioning.h"

#include <twrench/math/so3.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "check/verdict/exact_rows.h"

namespace twrench::check {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// The exact motions whose initial velocities differ by +-`step` rad/s along each axis.
struct Neighbours {
  Neighbours(const motion::FreeBody& body, std::span<const double> times, double step) {
    for (int i = 0; i < 3; ++i) {
      const Vector3d apart = step * Vector3d::Unit(i);
      const auto evaluate = [&](ExactRows& rows, const Vector3d& omega) {
        rows.evaluate(motion::ExactMotion({body.inertia(), omega}), times);
      };
      evaluate(ahead[static_cast<std::size_t>(i)], body.omega() + apart);
      evaluate(behind[static_cast<std::size_t>(i)], body.omega() - apart);
    }
  }

  std::array<ExactRows, 3> ahead, behind;
};

/// The largest factor by which the matrix lengthens a vector.
double largest_gain(const Matrix3d& change) {
  const Eigen::SelfAdjointEigenSolver<Matrix3d> squares(change.transpose() * change,
                                                        Eigen::EigenvaluesOnly);
  return std::sqrt(squares.eigenvalues()[2]);
}

Growth growth_at(const Neighbours& neighbours, std::size_t time, double step) {
  Matrix3d rates, attitude;
  for (int i = 0; i < 3; ++i) {
    const ExactRows& ahead = neighbours.ahead[static_cast<std::size_t>(i)];
    const ExactRows& behind = neighbours.behind[static_cast<std::size_t>(i)];
    rates.col(i) = (ahead.omega(time) - behind.omega(time)) / (2 * step);
    attitude.col(i) = so3::log(behind.X(time).transpose() * ahead.X(time)) / (2 * step);
  }
  return {largest_gain(rates), largest_gain(attitude)};
}

/// Growth up to each time, from differences over `step`.
std::vector<Growth> growth_over(const motion::FreeBody& body, std::span<const double> times,
                                double step) {
  const Neighbours neighbours(body, times, step);
  std::vector<Growth> growth(times.size());
  Growth most;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const Growth here = growth_at(neighbours, i, step);
    most.rates = std::max(most.rates, here.rates);
    most.attitude = std::max(most.attitude, here.attitude);
    growth[i] = most;
  }
  return growth;
}

}  // namespace

std::vector<Growth> error_growth(const motion::FreeBody& body, std::span<const double> times,
                                 double error) {
  const double speed = body.omega().norm();
  if (times.empty() || speed == 0) return std::vector<Growth>(times.size());
  const double least = std::max(error, 4 * std::numeric_limits<double>::epsilon() * speed);
  constexpr double first_step = 1e-6, shorter = 1.0 / 32, in_proportion = 1e-3;  // of the speed
  for (double step = std::max(first_step * speed, least);; step *= shorter) {
    step = std::max(step, least);
    std::vector<Growth> growth = growth_over(body, times, step);
    const bool is_small = growth.back().rates * step <= in_proportion * speed &&
                          growth.back().attitude * step <= in_proportion;
    if (is_small || step == least) return growth;
  }
}

}  // namespace twrench::check
