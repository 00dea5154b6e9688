#include "study/ladder.h"

#include <algorithm>
#include <cmath>

namespace twrench::study {
namespace {

/// Returns the largest number of the form 1, 2 or 5 times a power of ten that does not exceed x >
/// 0.
double round_number_below(double x) {
  const double power = std::pow(10.0, std::floor(std::log10(x)));
  for (const double digit : {5.0, 2.0}) {
    if (digit * power <= x * (1.0 + 1e-12)) return digit * power;
  }
  return power;
}

}  // namespace

std::vector<double> step_ladder(double duration, double speed) {
  // rad; not 0.2, so that |omega| slightly above 1 gives 0.2 s.
  constexpr double coarsest_turn = 0.21;
  constexpr double most_steps = 200'000;
  constexpr std::size_t rungs = 8;
  const double longest = speed > 0.0 ? coarsest_turn / speed : duration;
  double step = round_number_below(std::min(longest, duration / 4.0));
  std::vector<double> steps{step};
  while (steps.size() < rungs && duration / (step /= 2.0) <= most_steps) steps.push_back(step);
  return steps;
}

double early_time(double duration, double speed) {
  constexpr double turn = 10.5;  // rad; not 10, so that |omega| slightly above 1 gives 10 s
  return speed * duration > turn ? round_number_below(turn / speed) : duration;
}

std::vector<double> tolerance_ladder() {
  return {1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12};
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  if (values.size() % 2 != 0) return *middle;
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

std::optional<double> fitted_exponent(std::span<const PowerLawPoint> points) {
  std::vector<double> slopes;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      const double width = std::log(points[i].x / points[j].x);
      if (width != 0.0) slopes.push_back(std::log(points[i].y / points[j].y) / width);
    }
  }
  if (slopes.empty()) return std::nullopt;
  return median(std::move(slopes));
}

}  // namespace twrench::study
