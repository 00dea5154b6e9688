#include "check/law/attitude_rates.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "check/law/law.h"

namespace twrench::check {
namespace {

using recording::Row;

using Eigen::Quaterniond;
using Eigen::Vector3d;

/// Rows before and after the one whose rate is derived.
constexpr std::size_t reach = 3;

/// The largest |w| between neighbouring rows, rad/s.
double largest_speed(std::span<const Quaterniond> attitudes, std::span<const Row> rows) {
  double speed = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const double turn = attitudes[i - 1].angularDistance(attitudes[i]);
    speed = std::max(speed, turn / (rows[i].t - rows[i - 1].t));
  }
  return speed;
}

/// How many rows apart the error of order 6 about equals that of the attitudes.
std::size_t stride_for(double error, double turn_per_row) {
  constexpr double least = 0.01, most = 0.5, of_order_6 = 140;  // rad
  const double apart = std::clamp(std::pow(of_order_6 * error, 1.0 / 7), least, most);
  return static_cast<std::size_t>(std::max(1.0, apart / turn_per_row));
}

}  // namespace

RowsWithRates with_rates_of_attitude(std::span<const Row> rows, double error) {
  std::vector<Quaterniond> attitudes;
  for (const Row& row : rows) attitudes.push_back(state_of(row).X);
  const double speed = largest_speed(attitudes, rows);
  const double duration = rows.empty() ? 0 : rows.back().t - rows.front().t;
  const double turn = speed * duration / static_cast<double>(rows.size());
  constexpr double too_far = 0.8;  // rad: three times as far is less than half a turn
  if (!(turn > 0 && turn < too_far)) return {};
  const std::size_t stride = stride_for(error, turn), around = reach * stride;
  RowsWithRates result;
  for (std::size_t i = around; i + around < rows.size(); ++i) {
    std::array<double, 2 * reach + 1> times{};
    for (std::size_t k = 0; k < times.size(); ++k)
      times[k] = rows[i - around + k * stride].t - rows[i].t;
    const std::vector<double> weights = recording::derivative_weights(times);
    Row row = rows[i];
    row.omega.setZero();
    // At the row, the derivative of the rotation vector from its attitude is the rate.
    for (std::size_t k = 0; k < times.size(); ++k) {
      if (k == reach) continue;
      const Quaterniond& other = attitudes[i - around + k * stride];
      row.omega += weights[k] * rotation_vector(attitudes[i].conjugate() * other);
    }
    result.rows.push_back(row);
  }
  constexpr double gain = 1.08;  // of the weights 3/4, -3/20 and 1/60
  result.noise = gain * error / (turn * static_cast<double>(stride));
  return result;
}

}  // namespace twrench::check
