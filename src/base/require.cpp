#include "base/require.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace twrench {
namespace {

constexpr double greatest = std::numeric_limits<double>::max();

}  // namespace

double require_finite(const char* quantity, double value) {
  if (std::isfinite(value)) return value;
  throw OutOfRange(quantity, fmt::format("is {}, but must be finite", value),
                   {value, -greatest, greatest});
}

void require_finite(const char* quantity, std::span<const double> values) {
  const auto bad = std::ranges::find_if_not(values, [](double x) { return std::isfinite(x); });
  if (bad == values.end()) return;
  require_finite(fmt::format("{}[{}]", quantity, bad - values.begin()).c_str(), *bad);
}

double require_positive(const char* quantity, double value) {
  if (std::isfinite(value) && value > 0) return value;
  throw OutOfRange(quantity, fmt::format("is {}, but must be positive and finite", value),
                   {value, 0, greatest});
}

double require_not_negative(const char* quantity, double value) {
  if (std::isfinite(value) && value >= 0) return value;
  throw OutOfRange(quantity, fmt::format("is {}, but must be finite and not negative", value),
                   {value, 0, greatest});
}

}  // namespace twrench
