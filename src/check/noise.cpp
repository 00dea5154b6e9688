#include "check/noise.h"

#include <algorithm>
#include <cmath>

namespace twrench::check {
namespace {

/// Whether two variances are of one size, given the ratio of deviations that is let pass.
bool alike(double a, double b, double ratio) {
  return a <= ratio * ratio * b && b <= ratio * ratio * a;
}

}  // namespace

void DifferenceSums::add(const DifferenceSums& other) {
  second += other.second;
  fourth += other.fourth;
  count += other.count;
}

std::optional<DifferenceSums> DifferenceTable::add(double t, const Eigen::Vector3d& value) {
  std::ranges::rotate(times_, times_.begin() + 1);
  std::ranges::rotate(values_, values_.begin() + 1);
  times_.back() = t;
  values_.back() = value;
  if (++count_ < times_.size()) return std::nullopt;
  const double step = (times_[4] - times_[0]) / 4;
  constexpr double jitter = 1e-2;  // of a step, for times that are rounded
  for (std::size_t i = 1; i < times_.size(); ++i) {
    if (std::abs(times_[i] - times_[i - 1] - step) > jitter * step) return std::nullopt;
  }
  const auto& v = values_;
  const Eigen::Array3d second = v[2] - 2 * v[3] + v[4];
  const Eigen::Array3d fourth = v[0] - 4 * v[1] + 6 * v[2] - 4 * v[3] + v[4];
  // The sums of the squares of the coefficients.
  return DifferenceSums{second.square() / 6, fourth.square() / 70, 1};
}

std::optional<double> noise(const DifferenceSums& all, const DifferenceSums& first_quarter,
                            const DifferenceSums& last_quarter) {
  constexpr double fewest = 8;  // below, the ratios below tell nothing
  if (first_quarter.count < fewest || last_quarter.count < fewest) return std::nullopt;
  Eigen::Index most = 0;
  const double variance = (all.fourth / all.count).maxCoeff(&most);
  const auto mean = [most](const DifferenceSums& sums) { return sums.fourth[most] / sums.count; };
  const bool independent = alike(variance, all.second[most] / all.count, 1.3);
  const bool steady = alike(mean(first_quarter), mean(last_quarter), 2);
  if (!independent || !steady) return std::nullopt;
  return std::sqrt(variance);
}

}  // namespace twrench::check
