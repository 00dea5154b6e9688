#include <algorithm>
#include <cmath>

#include "picture/shapes/lathe.h"
#include "picture/shapes/shapes.h"

namespace twrench::picture {

namespace {

/// Returns the corner of a cone's outline at its end -1 or +1, where the cone has the radius
/// `radius`. `slant` is the latitude of the side's normal. The arc is as far inside the side as
/// inside the end.
Arc rounded_end(double radius, double end, double height, double slant, double bevel, int chords) {
  const double across = radius - bevel * (1 - end * std::sin(slant)) / std::cos(slant);
  return {{across, end * (height - bevel)},
          bevel,
          end < 0 ? evenly_spaced(-quarter, slant, chords) : evenly_spaced(slant, quarter, chords)};
}

/// The same at a point, which is rounded so little that the cone keeps its height. The pole is
/// omitted.
Arc rounded_tip(double height, double slant, double widest_bevel, int chords) {
  const double sine = std::sin(slant);
  const double bevel = widest_bevel * std::min(1.0, sine / (1 - sine));
  const double step = (quarter - slant) / (chords + 0.5);
  return {{0, height - bevel / sine}, bevel, evenly_spaced(slant, slant + chords * step, chords)};
}

}  // namespace

using Eigen::Vector3d;

ShapeTraits traits(const body::Cone& c) {
  // The radius halfway up gives about the same volume.
  const double radius = (c.radius + c.top_radius) / 2;
  return {.outline = {radius, 0},
          .occluder = capsule_in_box({radius, radius, c.length / 2}),
          .has_round_side = false,
          .middle = {0, 0},
          .symmetry = of_revolution,
          .ends = Vector3d::UnitZ()};
}

bool holds(const body::Cone& c, const Vector3d& point, double margin) {
  const double share = std::clamp(point.z() / c.length + 0.5, 0.0, 1.0);
  const double radius = c.radius + share * (c.top_radius - c.radius);
  const double slant = std::hypot(c.length, c.radius - c.top_radius) / c.length;
  return std::hypot(point.x(), point.y()) <= radius + slant * margin &&
         std::abs(point.z()) <= c.length / 2 + margin;
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

}  // namespace twrench::picture
