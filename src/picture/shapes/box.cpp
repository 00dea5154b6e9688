#include <cmath>

#include "picture/shapes/lathe.h"
#include "picture/shapes/shapes.h"

namespace twrench::picture {

using Eigen::Vector3d;

ShapeTraits traits(const body::Box& b) {
  const AxisCapsule capsule = capsule_in_box(body::bounding_box(b).sizes() / 2);
  return {.outline = {capsule.radius, 0},
          .occluder = capsule,
          .has_round_side = false,
          .middle = {0, 0},
          .symmetry = asymmetric,
          .ends = Eigen::Matrix3d::Identity()};
}

bool holds(const body::Box& b, const Vector3d& point, double margin) {
  return (point.cwiseAbs().array() <= b.size.array() / 2 + margin).all();
}

/// A box with rounded edges is a sphere of the bevel's radius, cut into octants that are moved
/// apart to the corners of an inner box.
Rings rings_of(const body::Box& box, double tolerance) {
  constexpr double edge_share = 0.08;
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

}  // namespace twrench::picture
