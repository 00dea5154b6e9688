#include "check/law/attitude_rates.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
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

/// The rate of row i from the rows `stride`, twice and three times as far before and after it.
Vector3d rate_of(std::span<const Quaterniond> attitudes, std::span<const Row> rows, std::size_t i,
                 std::size_t stride) {
  std::array<double, 2 * reach + 1> times{};
  const std::size_t first = i - reach * stride;
  for (std::size_t k = 0; k < times.size(); ++k) times[k] = rows[first + k * stride].t - rows[i].t;
  const std::vector<double> weights = recording::derivative_weights(times);
  // At the row, the derivative of the rotation vector from its attitude is the rate.
  Vector3d rate = Vector3d::Zero();
  for (std::size_t k = 0; k < times.size(); ++k) {
    if (k != reach)
      rate +=
          weights[k] * rotation_vector(attitudes[i].conjugate() * attitudes[first + k * stride]);
  }
  return rate;
}

/// The standard deviation of a rate, relative to the largest |w|.
double noise_of_rates(double error, double turn_per_row, std::size_t stride) {
  constexpr double gain = 1.08;  // of the weights 3/4, -3/20 and 1/60
  return gain * error / (turn_per_row * static_cast<double>(stride));
}

/// The root mean square difference of a component between the rates of rows `stride` apart and
/// those of half as far, in some rows of the whole file.
double difference_to_half(std::span<const Quaterniond> attitudes, std::span<const Row> rows,
                          std::size_t stride) {
  constexpr std::size_t most = 192;
  const std::size_t around = reach * stride, starts = rows.size() - 2 * around;
  const std::size_t count = std::min(most, starts);
  double squares = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = around + k * starts / count;
    squares += (rate_of(attitudes, rows, i, stride) - rate_of(attitudes, rows, i, stride / 2))
                   .squaredNorm();
  }
  return std::sqrt(squares / (3 * static_cast<double>(count)));
}

/// How many rows apart the error of order 6 about equals that of the attitudes, if the rates turn
/// as fast as the body.
std::size_t widest_stride(double error, double turn_per_row) {
  constexpr double least = 0.01, most = 0.5, of_order_6 = 140;  // rad
  const double apart = std::clamp(std::pow(of_order_6 * error, 1.0 / 7), least, most);
  return static_cast<std::size_t>(std::max(1.0, apart / turn_per_row));
}

/// Wrong laws turn the rates faster, so that the error of order 6 is larger. Half as far apart, it
/// is 64 times smaller, and the noise twice as large. The rows are brought closer until noise
/// explains the difference, or until noise makes it larger.
std::size_t stride_for(std::span<const Quaterniond> attitudes, std::span<const Row> rows,
                       double error, double turn_per_row, double speed) {
  constexpr double explained = 1.3;  // of both noises, which share some rows: 1.2
  std::size_t stride = widest_stride(error, turn_per_row);
  double wider = std::numeric_limits<double>::infinity();
  for (; stride > 1 && 2 * reach * stride < rows.size(); stride /= 2) {
    const double found = difference_to_half(attitudes, rows, stride);
    const double noise = speed * noise_of_rates(error, turn_per_row, stride / 2);
    if (found < explained * noise) return stride;
    if (found > wider) return 2 * stride;
    wider = found;
  }
  return stride;
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
  const std::size_t stride = stride_for(attitudes, rows, error, turn, speed);
  const std::size_t around = reach * stride;
  RowsWithRates result;
  for (std::size_t i = around; i + around < rows.size(); ++i) {
    Row row = rows[i];
    row.omega = rate_of(attitudes, rows, i, stride);
    result.rows.push_back(row);
  }
  result.noise = noise_of_rates(error, turn, stride);
  return result;
}

}  // namespace twrench::check
