#include "scene/limits.h"

#include <fmt/format.h>

#include <cmath>

#include "base/error.h"

namespace twrench::limits {

bool Limit::allows(double value) const {
  return (low_is_open ? value > low : value >= low) && value <= high;
}

std::string Limit::describe() const {
  const std::string why = why_low.empty() ? "" : fmt::format(" ({})", why_low);
  return fmt::format("{} {}{} and at most {}", low_is_open ? "greater than" : "at least", low, why,
                     high);
}

double check(const Limit& limit, const std::string& what, double value) {
  if (limit.allows(value)) return value;
  throw UsageError(what, fmt::format("is {}, but must be {}", value, limit.describe()));
}

Eigen::Vector3d check(const Limit& limit, const std::string& what, const Eigen::Vector3d& value) {
  for (const double entry : value) check(limit, what, entry);
  return value;
}

int check_whole(const Limit& limit, const std::string& what, double value) {
  if (limit.allows(value) && value == std::floor(value)) return static_cast<int>(value);
  throw UsageError(what,
                   fmt::format("is {}, but must be a whole number, {}", value, limit.describe()));
}

}  // namespace twrench::limits
