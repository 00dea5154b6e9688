#include "scene/limits.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include <cmath>

namespace twrench::scene::limits {

bool Limit::allows(double value) const { return value >= low && value <= high; }

std::string Limit::describe() const {
  const std::string why = why_low.empty() ? "" : fmt::format(" ({})", why_low);
  return fmt::format("at least {}{} and at most {}", low, why, high);
}

double check(const Limit& limit, const std::string& what, double value) {
  if (limit.allows(value)) return value;
  throw OutOfRange(what, fmt::format("is {}, but must be {}", value, limit.describe()),
                   {value, limit.low, limit.high});
}

Eigen::Vector3d check(const Limit& limit, const std::string& what, const Eigen::Vector3d& value) {
  for (const double entry : value) check(limit, what, entry);
  return value;
}

Eigen::Vector3d check_omega(const std::string& what, const Eigen::Vector3d& omega) {
  const double rate = check(coordinate, what, omega).stableNorm();
  if (rate == 0 || rate >= min_rotation_rate) return omega;
  throw OutOfRange(what,
                   fmt::format("has magnitude {:.6g} rad/s, but must be zero or at least {:.6g}",
                               rate, min_rotation_rate),
                   {rate, min_rotation_rate, coordinate.high});
}

Eigen::Vector3d check_moments(const std::string& what, const Eigen::Vector3d& moments) {
  const double ratio = moments.maxCoeff() / moments.minCoeff();
  if (moments.minCoeff() > 0 && ratio <= max_moment_ratio) return moments;
  throw InvalidArgument(
      what, fmt::format("the moments of inertia are {:.6g}, {:.6g} and {:.6g}, but the largest "
                        "must be at most {:.6g} times the smallest",
                        moments[0], moments[1], moments[2], max_moment_ratio));
}

double density_of_mass(const std::string& what, double grams, double volume) {
  const double result = check(mass, what, grams) / volume;
  if (density.allows(result)) return result;
  throw InvalidArgument(
      what, fmt::format("is {} g, which makes the density {:.6g} g/cm^3, but that must be {}",
                        grams, result, density.describe()));
}

int check_whole(const Limit& limit, const std::string& what, double value) {
  if (limit.allows(value) && value == std::floor(value)) return static_cast<int>(value);
  throw OutOfRange(what, fmt::format("is {}, but must be an integer, {}", value, limit.describe()),
                   {value, limit.low, limit.high});
}

}  // namespace twrench::scene::limits
