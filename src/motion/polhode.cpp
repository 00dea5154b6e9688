#include <fmt/format.h>
#include <twrench/motion/polhode.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/require.h"
#include "body/moments.h"

namespace twrench::motion {
namespace {

using body::PrincipalAxes;
using Eigen::Vector3d;

/// Relative difference below which two moments count as equal, because a picture cannot show it.
constexpr double alike = 1e-9;

bool differ(double a, double b) { return b - a > alike * b; }

void check(const EnergyLevel& level) {
  body::require_ascending_moments(level.moments);
  if (!differ(level.moments[0], level.moments[2])) {
    throw InvalidArgument("moments", "must not all be equal");
  }
  if (level.axis != PrincipalAxes::least && level.axis != PrincipalAxes::greatest) {
    throw InvalidArgument("axis", "must be the axis of least or of greatest moment");
  }
  if (level.side != 1 && level.side != -1) {
    throw OutOfRange("side", fmt::format("is {}, but must be 1 or -1", level.side),
                     {level.side, -1, 1});
  }
  const double least = 1 / level.moments[2], greatest = 1 / level.moments[0];
  if (level.energy >= least * (1 - alike) && level.energy <= greatest * (1 + alike)) return;
  throw OutOfRange("energy",
                   fmt::format("is {}, but must be {} to {}", level.energy, least, greatest),
                   {level.energy, least, greatest});
}

/// Returns a / b, clamped to [0, 1] against rounding; 0 if both vanish.
double share(double a, double b) { return b > 0 ? std::clamp(a / b, 0.0, 1.0) : 0; }

}  // namespace

Vector3d EnergyLevel::at(double phi) const {
  check(*this);
  require_finite("phi", phi);
  const Vector3d inverse = moments.cwiseInverse();
  const int other = 2 - axis;
  const double excess = std::abs(energy - inverse[axis]);
  const double amplitude = share(excess, inverse[0] - inverse[2]);
  const double intermediate = share(excess, std::abs(inverse[1] - inverse[axis]));
  const double c = std::cos(phi), s = std::sin(phi);
  Vector3d mu;
  mu[other] = std::sqrt(amplitude) * c;
  mu[1] = std::sqrt(intermediate) * s;
  // 1 - mu_1^2 - mu_other^2, without cancellation.
  mu[axis] = side * std::sqrt(c * c * (1 - amplitude) + s * s * (1 - intermediate));
  return mu;
}

bool EnergyLevel::is_separatrix() const {
  check(*this);
  return std::abs(energy * moments[1] - 1) < alike && differ(moments[0], moments[1]) &&
         differ(moments[1], moments[2]);
}

std::optional<EnergyLevel> level_through(const Vector3d& moments, const Vector3d& mu) {
  body::require_ascending_moments(moments);
  require_finite_entries("mu", mu);
  if (!(std::abs(mu.squaredNorm() - 1) < alike)) {
    throw InvalidArgument("mu", "must be a unit vector");
  }
  if (!differ(moments[0], moments[2])) return std::nullopt;
  const double energy = (mu.array().square() / moments.array()).sum();
  const bool about_least = differ(moments[0], moments[1]) &&
                           (energy * moments[1] > 1 || !differ(moments[1], moments[2]));
  const PrincipalAxes::Axis axis = about_least ? PrincipalAxes::least : PrincipalAxes::greatest;
  return EnergyLevel{moments, energy, axis, std::copysign(1.0, mu[axis])};
}

std::vector<EnergyLevel> level_family(const Vector3d& moments, int count) {
  body::require_ascending_moments(moments);
  require_not_negative("count", count);
  std::vector<EnergyLevel> levels;
  const Vector3d inverse = moments.cwiseInverse();
  for (const PrincipalAxes::Axis axis : {PrincipalAxes::least, PrincipalAxes::greatest}) {
    if (!differ(moments[std::min<int>(axis, 1)], moments[std::max<int>(axis, 1)])) continue;
    for (int i = 1; i <= count; ++i) {
      const double sine = std::sin(std::numbers::pi / 2 * i / (count + 1));
      const double energy = inverse[axis] + sine * sine * (inverse[1] - inverse[axis]);
      for (const double side : {1.0, -1.0}) levels.push_back({moments, energy, axis, side});
    }
  }
  return levels;
}

std::optional<std::array<Vector3d, 2>> separatrix(const Vector3d& moments) {
  body::require_ascending_moments(moments);
  if (!differ(moments[0], moments[1]) || !differ(moments[1], moments[2])) return std::nullopt;
  const Vector3d inverse = moments.cwiseInverse();
  const double least = std::sqrt((inverse[1] - inverse[2]) / (inverse[0] - inverse[2]));
  const double greatest = std::sqrt((inverse[0] - inverse[1]) / (inverse[0] - inverse[2]));
  return std::array{Vector3d(least, 0, greatest), Vector3d(least, 0, -greatest)};
}

Annulus herpolhode_annulus(const EnergyLevel& level) {
  check(level);
  // |omega| is largest and smallest where the polhode crosses the coordinate planes.
  const auto radius = [&](double phi) {
    const Vector3d omega = level.at(phi).cwiseQuotient(level.moments) / level.energy;
    return std::sqrt(std::max(omega.squaredNorm() - 1, 0.0));
  };
  const double one = radius(0), other = radius(std::numbers::pi / 2);
  return {std::min(one, other), std::max(one, other)};
}

}  // namespace twrench::motion
