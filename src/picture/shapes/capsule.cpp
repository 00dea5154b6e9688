#include <algorithm>
#include <cmath>

#include "picture/shapes/lathe.h"
#include "picture/shapes/shapes.h"

namespace twrench::picture {

using Eigen::Vector3d;

ShapeTraits traits(const body::Capsule& c) {
  return {.outline = {c.radius, c.radius},
          .occluder = AxisCapsule{2, c.length / 2, c.radius},
          .has_round_side = true,
          .middle = {0, 0},
          .symmetry = of_revolution,
          .ends = Vector3d::UnitZ()};
}

bool holds(const body::Capsule& c, const Vector3d& point, double margin) {
  const double beyond = std::max(std::abs(point.z()) - c.length / 2, 0.0);
  return std::hypot(std::hypot(point.x(), point.y()), beyond) <= c.radius + margin;
}

/// The poles are omitted: the first and the last ring are half a step from them.
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

}  // namespace twrench::picture
