#include "picture/shapes/shapes.h"

#include <algorithm>

namespace twrench::picture {

AxisCapsule capsule_in_box(const Eigen::Vector3d& half_sizes) {
  Eigen::Index longest = 2;
  half_sizes.maxCoeff(&longest);
  const double radius = (half_sizes.sum() - half_sizes[longest]) / 2;
  return {longest, std::max(0.0, half_sizes[longest] - radius / 2), radius};
}

ShapeTraits traits_of(const body::Shape& shape) {
  return std::visit([](const auto& solid) { return traits(solid); }, shape);
}

}  // namespace twrench::picture
