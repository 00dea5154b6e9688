#include "base/require.h"

#include <fmt/format.h>

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

double require_positive(const char* quantity, double value) {
  if (std::isfinite(value) && value > 0) return value;
  throw OutOfRange(quantity, fmt::format("is {}, but must be positive and finite", value),
                   {value, 0, greatest});
}

}  // namespace twrench
