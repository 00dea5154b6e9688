#include <twrench/body/mass_properties.h>

#include "picture/shapes/shapes.h"

namespace twrench::picture {

ShapeTraits traits(const body::Mesh& m) {
  return {.outline = {capsule_in_box(body::bounding_box(m).sizes() / 2).radius, 0},
          .occluder = std::nullopt,
          .has_round_side = false,
          .middle = {0, 0},
          .symmetry = asymmetric,
          .ends = body::principal_axes(m.integrals.inertia).axes};
}

bool holds(const body::Mesh&, const Eigen::Vector3d&, double) { return false; }

}  // namespace twrench::picture
