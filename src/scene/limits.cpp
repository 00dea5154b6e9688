#include "scene/limits.h"

#include <fmt/format.h>
#include <twrench/base/error.h>
#include <twrench/body/mass_properties.h>

#include <cmath>

namespace twrench::scene::limits {
namespace {

/// Throws unless two entries that should be equal are, to round-off.
void require_symmetric(const std::string& what, const Eigen::Matrix3d& inertia) {
  constexpr double round_off = 1e-12;
  Eigen::Index row = 0, column = 0;
  const double apart = (inertia - inertia.transpose()).cwiseAbs().maxCoeff(&row, &column);
  if (apart <= round_off * inertia.cwiseAbs().maxCoeff()) return;
  throw InvalidArgument(
      what,
      fmt::format("must be symmetric, but I{0}{1} is {2} and I{1}{0} is {3}", "xyz"[column],
                  "xyz"[row], inertia(column, row), inertia(row, column)),
      "give both the same value");
}

/// Throws unless the magnitude of a vector is zero or at least `least`.
void require_not_tiny(const std::string& what, const Eigen::Vector3d& vector, double least,
                      double most, const char* unit) {
  const double size = vector.stableNorm();
  if (size == 0 || size >= least) return;
  throw OutOfRange(what,
                   fmt::format("has magnitude {:.6g} {}, but must be zero or at least {:.6g}", size,
                               unit, least),
                   {size, least, most});
}

/// Throws unless the principal moments of a matrix with products of inertia are positive.
void require_positive_definite(const std::string& what, const Eigen::Vector3d& moments) {
  if (moments.minCoeff() > 0) return;
  throw InvalidArgument(
      what,
      fmt::format("its principal moments are {:.6g}, {:.6g} and {:.6g}, but each must be positive",
                  moments[0], moments[1], moments[2]),
      "check the signs of the products of inertia: Ixy is the entry of the matrix, minus the "
      "integral of x y dm");
}

}  // namespace

bool Limit::allows(double value) const { return value >= low && value <= high; }

std::string Limit::describe() const {
  const std::string why = why_low.empty() ? "" : fmt::format(" ({})", why_low);
  return fmt::format("at least {}{} and at most {}{}", low, why, high,
                     or_infinite ? ", or inf" : "");
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
  require_not_tiny(what, check(coordinate, what, omega), min_rotation_rate, coordinate.high,
                   "rad/s");
  return omega;
}

Eigen::Vector3d check_wheel(const std::string& what, const Eigen::Vector3d& momentum) {
  require_not_tiny(what, check(angular_momentum, what, momentum), min_wheel_momentum,
                   angular_momentum.high, "g cm^2/s");
  return momentum;
}

Eigen::Quaterniond check_rotation(const std::string& what, const Eigen::Vector4d& quaternion) {
  constexpr double most_difference = 0.1, round_off = 1e-15;
  const double norm = quaternion.stableNorm();
  if (!(std::abs(norm - 1) <= most_difference)) {
    throw InvalidArgument(what, fmt::format("has the length {:.6g}", norm),
                          "a quaternion of a rotation has the length 1");
  }
  // A quaternion that is already of unit length keeps its bits.
  const double divisor = std::abs(norm - 1) <= round_off ? 1 : norm;
  const Eigen::Vector4d q = quaternion / divisor;
  return {q[0], q[1], q[2], q[3]};
}

Eigen::Vector3d check_moments(const std::string& what, const Eigen::Vector3d& moments) {
  const double ratio = moments.maxCoeff() / moments.minCoeff();
  if (moments.minCoeff() > 0 && ratio <= max_moment_ratio) return moments;
  throw InvalidArgument(
      what, fmt::format("the moments of inertia are {:.6g}, {:.6g} and {:.6g}, but the largest "
                        "must be at most {:.6g} times the smallest",
                        moments[0], moments[1], moments[2], max_moment_ratio));
}

Eigen::Matrix3d check_inertia(const std::string& what, const Eigen::Matrix3d& inertia) {
  check(moment, what, Eigen::Vector3d(inertia.diagonal()));
  for (const double entry : inertia.reshaped()) check(matrix_entry, what, entry);
  require_symmetric(what, inertia);
  // Adding zero makes each zero positive.
  const Eigen::Matrix3d symmetric = (inertia + inertia.transpose()).array() / 2 + 0.0;
  const Eigen::Vector3d moments = body::principal_axes(symmetric).moments;
  require_positive_definite(what, moments);
  check_moments(what, check(moment, what, moments));
  return symmetric;
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
