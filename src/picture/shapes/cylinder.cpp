#include <cmath>

#include "picture/shapes/lathe.h"
#include "picture/shapes/shapes.h"

namespace twrench::picture {

using Eigen::Vector3d;

ShapeTraits traits(const body::Cylinder& c) {
  const AxisCapsule occluder = capsule_in_box(body::bounding_box(c).sizes() / 2);
  return {.outline = {c.radius, 0},
          .occluder = occluder,
          .has_round_side = occluder.axis == 2,
          .middle = {0, 0},
          .symmetry = of_revolution,
          .ends = Vector3d::UnitZ()};
}

bool holds(const body::Cylinder& c, const Vector3d& point, double margin) {
  return std::hypot(point.x(), point.y()) <= c.radius + margin &&
         std::abs(point.z()) <= c.length / 2 + margin;
}

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

}  // namespace twrench::picture
