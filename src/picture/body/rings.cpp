#include "picture/body/rings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace twrench::picture {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// Shares of half the smallest dimension.
constexpr double rim_share = 0.04, edge_share = 0.08, widest_bevel_share = 0.12;
constexpr double least_bevel = 12;  // in tolerances
constexpr double quarter = std::numbers::pi / 2;

// Minimum number of chords per quarter turn, however small the picture: normals are interpolated
// linearly.
constexpr int least_of_body = 8;
constexpr int least_of_bevel = 2;

/// Returns how many chords a quarter of a circle of `radius` needs to stay within `tolerance` of
/// it.
int chords_of_quarter(double radius, double tolerance, int least) {
  if (tolerance >= radius) return least;
  const double half_angle = std::acos(1 - tolerance / radius);
  return std::max(least, static_cast<int>(std::ceil(quarter / (2 * half_angle))));
}

double bevel_of(double half, double share, double tolerance) {
  return std::max(share * half, std::min(least_bevel * tolerance, widest_bevel_share * half));
}

double rim_bevel(double radius, double length, double tolerance) {
  return bevel_of(std::min(radius, length / 2), rim_share, tolerance);
}

/// The rims of a wall are close together, and rounded more than others.
double wall_bevel(double wall, double length, double tolerance) {
  constexpr double share = 0.16, widest_share = 0.9;
  const double half = std::min(wall, length) / 2;
  return std::max(share * half, std::min(2 * least_bevel * tolerance, widest_share * half));
}

Vector3d on_unit_sphere(double longitude, double latitude) {
  return {std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
          std::sin(latitude)};
}

/// The angles from `first` to `last`, both included.
std::vector<double> evenly_spaced(double first, double last, int count) {
  std::vector<double> result;
  for (int i = 0; i <= count; ++i) result.push_back(first + (last - first) * i / count);
  return result;
}

/// The latitudes of the bevel at the end -1 or +1 of a shape, upwards.
std::vector<double> bevel_latitudes(double end, int chords) {
  return end < 0 ? evenly_spaced(-quarter, 0, chords) : evenly_spaced(0, quarter, chords);
}

/// An arc of the outline of a solid of revolution, in the half plane (distance from the axis, z).
/// Straight lines lead from one to the next.
struct Arc {
  Vector2d centre;
  double radius;
  std::vector<double> latitudes;  ///< Of its points, the directions of their normals.
};

/// How many of the widest circle's points a circle has as one: where the outline comes close to the
/// axis, facets would be slivers.
int points_in_one(double radius, double widest, int around) {
  constexpr int least = 16;  // on a circle
  int step = 1;
  while (2 * step * radius < widest && around / (2 * step) >= least) step *= 2;
  return step;
}

/// Rotates an outline about the z axis; it goes upwards on the outside.
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

/// The corner of a cone's outline at its end -1 or +1, with that radius there. `slant` is the
/// latitude of the side's normal. The arc is as far inside the side as inside the end.
Arc rounded_end(double radius, double end, double height, double slant, double bevel, int chords) {
  const double across = radius - bevel * (1 - end * std::sin(slant)) / std::cos(slant);
  return {{across, end * (height - bevel)},
          bevel,
          end < 0 ? evenly_spaced(-quarter, slant, chords) : evenly_spaced(slant, quarter, chords)};
}

/// The same at a point, which is rounded so little that the cone keeps its height; the pole is left
/// out.
Arc rounded_tip(double height, double slant, double widest_bevel, int chords) {
  const double sine = std::sin(slant);
  const double bevel = widest_bevel * std::min(1.0, sine / (1 - sine));
  const double step = (quarter - slant) / (chords + 0.5);
  return {{0, height - bevel / sine}, bevel, evenly_spaced(slant, slant + chords * step, chords)};
}

}  // namespace

Rings rings_of(const body::Cylinder& cylinder, double tolerance) {
  const double bevel = rim_bevel(cylinder.radius, cylinder.length, tolerance);
  const int along_bevel = chords_of_quarter(bevel, tolerance, least_of_bevel);
  std::vector<Arc> outline;
  for (const double end : {-1.0, 1.0}) {
    outline.push_back({{cylinder.radius - bevel, end * (cylinder.length / 2 - bevel)},
                       bevel,
                       bevel_latitudes(end, along_bevel)});
  }
  Rings result = lathed(outline, cylinder.radius, tolerance);
  result.side = static_cast<std::size_t>(along_bevel);
  result.bevel = bevel;
  return result;
}

/// The poles are left out: the first and the last ring are half a step from them.
Rings rings_of(const body::Capsule& capsule, double tolerance) {
  const int chords = chords_of_quarter(capsule.radius, tolerance, least_of_body);
  const double step = quarter / (chords + 0.5);
  std::vector<Arc> outline;
  for (const double end : {-1.0, 1.0}) {
    const double lowest = end < 0 ? step / 2 - quarter : 0;
    outline.push_back({{0, end * capsule.length / 2},
                       capsule.radius,
                       evenly_spaced(lowest, lowest + chords * step, chords)});
  }
  Rings result = lathed(outline, capsule.radius, tolerance);
  result.side = static_cast<std::size_t>(chords);
  return result;
}

Rings rings_of(const body::Cone& cone, double tolerance) {
  const double half = cone.length / 2;
  const double slant = std::atan2(cone.radius - cone.top_radius, cone.length);
  const bool has_tip = cone.top_radius == 0;
  const double narrow = has_tip ? cone.radius : std::min(cone.radius, cone.top_radius);
  const double bevel = rim_bevel(narrow, cone.length, tolerance);
  const int chords = chords_of_quarter(bevel, tolerance, least_of_bevel);
  const Arc top = has_tip ? rounded_tip(half, slant, bevel, chords)
                          : rounded_end(cone.top_radius, 1, half, slant, bevel, chords);
  std::vector<Arc> outline{rounded_end(cone.radius, -1, half, slant, bevel, chords)};
  // Rings where the side is half as wide, a quarter, and so on, so that its facets stay wide.
  for (double radius = cone.radius / 2; radius > std::max(2 * top.centre.x(), 2 * top.radius);
       radius /= 2) {
    const double share = (cone.radius - radius) / (cone.radius - cone.top_radius);
    outline.push_back({{radius, (share - 0.5) * cone.length}, 0, {slant}});
  }
  outline.push_back(top);
  return lathed(outline, std::max(cone.radius, cone.top_radius), tolerance);
}

Rings rings_of(const body::Torus& torus, double tolerance) {
  const int chords = 4 * chords_of_quarter(torus.tube_radius, tolerance, least_of_body);
  std::vector<double> latitudes = evenly_spaced(-quarter, 3 * quarter, chords);
  latitudes.pop_back();
  Rings result = lathed({{{torus.radius, 0}, torus.tube_radius, latitudes}},
                        torus.radius + torus.tube_radius, tolerance);
  result.has_hole = true;
  return result;
}

Rings rings_of(const body::Tube& tube, double tolerance) {
  const double wall = tube.radius - tube.inner_radius;
  const double bevel = wall_bevel(wall, tube.length, tolerance);
  const int chords = chords_of_quarter(bevel, tolerance, least_of_bevel);
  const double height = tube.length / 2 - bevel;
  const double outside = tube.radius - bevel, inside = tube.inner_radius + bevel;
  std::vector<Arc> outline;
  for (const Vector2d& centre : {Vector2d(outside, -height), Vector2d(outside, height),
                                 Vector2d(inside, height), Vector2d(inside, -height)}) {
    const double first = -quarter + quarter * static_cast<double>(outline.size());
    outline.push_back({centre, bevel, evenly_spaced(first, first + quarter, chords)});
  }
  Rings result = lathed(outline, tube.radius, tolerance);
  result.has_hole = true;
  result.side = static_cast<std::size_t>(chords);
  result.bevel = bevel;
  return result;
}

/// A box with rounded edges is a sphere of the bevel's radius, cut into octants that are moved
/// apart to the corners of an inner box.
Rings rings_of(const body::Box& box, double tolerance) {
  const double bevel = bevel_of(box.size.minCoeff() / 2, edge_share, tolerance);
  const Vector3d inner = (box.size.array() / 2 - bevel).matrix();
  const int chords = chords_of_quarter(bevel, tolerance, least_of_bevel);
  Rings result;
  for (const double end : {-1.0, 1.0}) {
    for (const double latitude : bevel_latitudes(end, chords)) {
      auto& ring = result.rings.emplace_back();
      for (int octant = 0; octant < 4; ++octant) {
        const Vector3d middle = on_unit_sphere((octant + 0.5) * quarter, 0);
        const Vector3d corner(std::copysign(inner.x(), middle.x()),
                              std::copysign(inner.y(), middle.y()), end * inner.z());
        for (const double longitude :
             evenly_spaced(octant * quarter, (octant + 1) * quarter, chords)) {
          const Vector3d normal = on_unit_sphere(longitude, latitude);
          ring.push_back({corner + bevel * normal, normal});
        }
      }
    }
  }
  return result;
}

Rings rings_of(const body::Ellipsoid& ellipsoid, double tolerance) {
  const int chords = chords_of_quarter(ellipsoid.radii.maxCoeff(), tolerance, least_of_body);
  Rings result;
  for (int j = 0; j < 2 * chords; ++j) {
    auto& ring = result.rings.emplace_back();
    const double latitude = quarter * ((j + 0.5) / chords - 1);  // half a step from the poles
    for (int i = 0; i < 4 * chords; ++i) {
      const Vector3d unit = on_unit_sphere(quarter * i / chords, latitude);
      ring.push_back(
          {unit.cwiseProduct(ellipsoid.radii), unit.cwiseQuotient(ellipsoid.radii).normalized()});
    }
  }
  return result;
}

}  // namespace twrench::picture
