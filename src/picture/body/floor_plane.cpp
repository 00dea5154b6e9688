#include "picture/body/floor_plane.h"

#include <Eigen/LU>

namespace twrench::picture {

double floor_height(double radius) {
  constexpr double gap = 0.06;  // in radii
  return -(1 + gap) * radius;
}

Eigen::Matrix3d floor_from_device(const Camera& camera, double radius) {
  const Eigen::Matrix4d clip_from_space = camera.projection * camera.view;
  const double height = floor_height(radius);
  Eigen::Matrix3d clip_from_floor;
  int row = 0;
  for (const int i : {0, 1, 3}) {
    clip_from_floor.row(row++) << radius * clip_from_space(i, 0), radius * clip_from_space(i, 2),
        height * clip_from_space(i, 1) + clip_from_space(i, 3);
  }
  return clip_from_floor.inverse();
}

}  // namespace twrench::picture
