#include "picture/shapes/lathe.h"
#include "picture/shapes/shapes.h"

namespace twrench::picture {

using Eigen::Vector3d;

ShapeTraits traits(const body::Ellipsoid& e) {
  const AxisCapsule capsule = capsule_in_box(body::bounding_box(e).sizes() / 2);
  return {.outline = {capsule.radius, capsule.radius},
          .occluder = capsule,
          .has_round_side = false,
          .middle = {0, 0},
          .symmetry = e.radii / e.radii.maxCoeff(),
          .ends = Eigen::Matrix3d::Identity()};
}

bool holds(const body::Ellipsoid& e, const Vector3d& point, double margin) {
  return point.cwiseQuotient((e.radii.array() + margin).matrix()).norm() <= 1;
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
