#include "picture/body/bounding_radius.h"

#include <algorithm>

namespace twrench::picture {

double bounding_radius(std::span<const body::Part> parts) {
  double result = 0;
  for (const body::Part& part : parts) {
    const Eigen::Vector3d origin = -part.body_from_part.transpose() * part.position;
    result = std::max(result, body::bounding_radius(part.shape, origin));
  }
  return result;
}

double extent_along(const body::Part& part, const Eigen::Vector3d& direction) {
  const Eigen::Vector3d own = part.body_from_part.transpose() * direction;
  return direction.dot(part.position) + own.dot(body::support(part.shape, own));
}

}  // namespace twrench::picture
