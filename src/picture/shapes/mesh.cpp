#include <twrench/body/mass_properties.h>

#include "picture/shapes/shapes.h"

namespace twrench::picture {

ShapeTraits traits(const body::Mesh& m) {
  constexpr double thickest_foil = 0.001;  // cm; kitchen foil is thicker
  return {.outline = {capsule_in_box(body::bounding_box(m).sizes() / 2).radius, 0},
          .occluder = std::nullopt,
          .has_round_side = false,
          .is_foil = m.shell > 0 && m.shell <= thickest_foil,
          .middle = {0, 0},
          .symmetry = asymmetric,
          .ends = body::principal_axes(m.integrals.inertia).axes};
}

bool holds(const body::Mesh&, const Eigen::Vector3d&, double) { return false; }

}  // namespace twrench::picture
