#include <cmath>

#include "picture/shapes/lathe.h"
#include "picture/shapes/shapes.h"

namespace twrench::picture {

using Eigen::Vector3d;

ShapeTraits traits(const body::Torus& t) {
  return {.outline = {t.tube_radius, t.tube_radius},
          .occluder = std::nullopt,
          .has_round_side = false,
          .middle = {t.radius, 0},
          .symmetry = of_revolution,
          .ends = Eigen::Matrix3d::Identity().leftCols<2>()};
}

bool holds(const body::Torus& t, const Vector3d& point, double margin) {
  return std::hypot(std::hypot(point.x(), point.y()) - t.radius, point.z()) <=
         t.tube_radius + margin;
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

}  // namespace twrench::picture
