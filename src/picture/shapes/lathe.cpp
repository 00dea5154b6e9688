#include "picture/shapes/lathe.h"

#include <algorithm>
#include <cmath>

namespace twrench::picture {
namespace {

using Eigen::Vector3d;

/// Returns how many points of the widest circle are merged into one point of a smaller circle.
/// Without this, facets would be slivers where the outline comes close to the axis.
int points_in_one(double radius, double widest, int around) {
  constexpr int least = 16;  // on a circle
  int step = 1;
  while (2 * step * radius < widest && around / (2 * step) >= least) step *= 2;
  return step;
}

}  // namespace

int chords_of_quarter(double radius, double tolerance, int least) {
  if (tolerance >= radius) return least;
  const double half_angle = std::acos(1 - tolerance / radius);
  return std::max(least, static_cast<int>(std::ceil(quarter / (2 * half_angle))));
}

double bevel_of(double half, double share, double tolerance) {
  constexpr double widest_share = 0.12;
  return std::max(share * half, std::min(least_bevel * tolerance, widest_share * half));
}

double rim_bevel(double radius, double length, double tolerance) {
  constexpr double rim_share = 0.04;
  return bevel_of(std::min(radius, length / 2), rim_share, tolerance);
}

Vector3d on_unit_sphere(double longitude, double latitude) {
  return {std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
          std::sin(latitude)};
}

std::vector<double> evenly_spaced(double first, double last, int count) {
  std::vector<double> result;
  for (int i = 0; i <= count; ++i) result.push_back(first + (last - first) * i / count);
  return result;
}

std::vector<double> bevel_latitudes(double end, int chords) {
  return end < 0 ? evenly_spaced(-quarter, 0, chords) : evenly_spaced(0, quarter, chords);
}

Rings lathed(const std::vector<Arc>& outline, double widest, double tolerance) {
  const int around = 4 * chords_of_quarter(widest, tolerance, least_of_body);
  Rings result;
  for (const Arc& arc : outline) {
    for (const double latitude : arc.latitudes) {
      auto& ring = result.rings.emplace_back();
      const double radius = arc.centre.x() + arc.radius * std::cos(latitude);
      const int step = points_in_one(radius, widest, around);
      for (int i = 0; i < around; ++i) {
        const double longitude = 4 * quarter * (i - i % step) / around;
        const Vector3d normal = on_unit_sphere(longitude, latitude);
        const Vector3d inner = arc.centre.x() * on_unit_sphere(longitude, 0);
        ring.push_back({inner + Vector3d(0, 0, arc.centre.y()) + arc.radius * normal, normal});
      }
    }
  }
  return result;
}

}  // namespace twrench::picture
