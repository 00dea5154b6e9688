#include "motion/series_steps.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include <algorithm>
#include <cmath>

namespace twrench::motion {

/// The order must be even because Horner's rule takes the powers in pairs.
std::size_t checked_order(const Taylor& method) {
  constexpr int greatest = max_taylor_order;
  const int order = method.order;
  if (order >= 2 && order <= greatest && order % 2 == 0) return static_cast<std::size_t>(order);
  throw OutOfRange("order", fmt::format("is {}, but must be even, and 2 to {}", order, greatest),
                   {double(order), 2, double(greatest)});
}

double LastTerms::after(double s) const {
  const double power = std::pow(std::abs(s), static_cast<double>(order - 1));
  return std::max(before, last * std::abs(s)) * power;
}

double LastTerms::longest_time(double tolerance) const {
  const auto p = static_cast<double>(order);
  double s = std::pow(tolerance / before, 1 / (p - 1));
  if (last * s > before) s = std::pow(tolerance / last, 1 / p);
  // No angle changes by more than s in the time s, and s^k/k! decreases for k > s.
  return std::min(s, 0.4 * p);
}

}  // namespace twrench::motion
