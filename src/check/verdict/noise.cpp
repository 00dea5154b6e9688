#include "check/verdict/noise.h"

#include <algorithm>
#include <cmath>

namespace twrench::check {
namespace {

/// Whether two variances are equal up to the ratio of their standard deviations.
bool alike(double a, double b, double ratio) {
  return a <= ratio * ratio * b && b <= ratio * ratio * a;
}

}  // namespace

void DifferenceSums::add(const DifferenceSums& other) {
  fourth += other.fourth;
  sixth += other.sixth;
  count += other.count;
}

std::optional<DifferenceSums> DifferenceTable::add(double t, const Eigen::Vector3d& value) {
  std::shift_left(times_.begin(), times_.end(), 1);
  std::shift_left(values_.begin(), values_.end(), 1);
  times_.back() = t;
  values_.back() = value;
  if (++count_ < times_.size()) return std::nullopt;
  const double step = (times_.back() - times_.front()) / static_cast<double>(times_.size() - 1);
  constexpr double jitter = 1e-2;  // of a step, for times that are rounded
  for (std::size_t i = 1; i < times_.size(); ++i) {
    if (std::abs(times_[i] - times_[i - 1] - step) > jitter * step) return std::nullopt;
  }
  const auto& v = values_;
  const Eigen::Array3d fourth = v[1] - 4 * v[2] + 6 * v[3] - 4 * v[4] + v[5];
  const Eigen::Array3d sixth =
      v[0] - 6 * v[1] + 15 * v[2] - 20 * v[3] + 15 * v[4] - 6 * v[5] + v[6];
  // The sums of the squares of the coefficients.
  return DifferenceSums{fourth.square() / 70, sixth.square() / 924, 1};
}

std::optional<double> noise(const DifferenceSums& all, const DifferenceSums& first_quarter,
                            const DifferenceSums& last_quarter) {
  constexpr double fewest = 8;  // with fewer, the ratios below mean nothing
  if (all.count < fewest) return std::nullopt;
  Eigen::Index most = 0;
  const double variance = (all.sixth / all.count).maxCoeff(&most);
  const auto mean = [most](const DifferenceSums& sums) { return sums.sixth[most] / sums.count; };
  // A deviation that is estimated from few rows is off by a factor, the logarithm of which has the
  // standard deviation 0.9 / sqrt(count) beside another difference of the same rows, and 3.5 /
  // sqrt(count) between the quarters. Three of them are allowed.
  const double few = 1 / std::sqrt(all.count);
  const bool independent =
      alike(variance, all.fourth[most] / all.count, std::max(1.3, std::exp(2.6 * few)));
  constexpr double fewest_in_quarter = 4;
  const bool steady =
      std::min(first_quarter.count, last_quarter.count) < fewest_in_quarter ||
      alike(mean(first_quarter), mean(last_quarter), std::max(2.0, std::exp(10.4 * few)));
  if (!independent || !steady) return std::nullopt;
  return std::sqrt(variance);
}

}  // namespace twrench::check
