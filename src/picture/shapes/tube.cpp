#include <algorithm>
#include <cmath>

#include "picture/shapes/lathe.h"
#include "picture/shapes/shapes.h"

namespace twrench::picture {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

/// The rims of a wall are close together and therefore rounded more than others.
double wall_bevel(double wall, double length, double tolerance) {
  constexpr double share = 0.16, widest_share = 0.9;
  const double half = std::min(wall, length) / 2;
  return std::max(share * half, std::min(2 * least_bevel * tolerance, widest_share * half));
}

}  // namespace

ShapeTraits traits(const body::Tube& t) {
  return {.outline = {t.radius, 0},
          .occluder = std::nullopt,
          .has_round_side = false,
          .middle = {(t.radius + t.inner_radius) / 2, t.length / 2},
          .symmetry = of_revolution,
          .ends = Vector3d::UnitZ()};
}

bool holds(const body::Tube& t, const Vector3d& point, double margin) {
  const double across = std::hypot(point.x(), point.y());
  return across <= t.radius + margin && across >= t.inner_radius - margin &&
         std::abs(point.z()) <= t.length / 2 + margin;
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

}  // namespace twrench::picture
