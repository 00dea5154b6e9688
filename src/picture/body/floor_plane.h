#pragma once

#include <Eigen/Core>

#include "picture/space/camera.h"

namespace twrench::picture {

/// Returns the height of the floor, y in space, in cm, for a body of that bounding radius: just
/// below the space that the rotating body sweeps.
double floor_height(double radius);

/// Returns the matrix that maps (x, y, 1) in device coordinates, -1 to 1 across and up, to
/// (x, z, 1) / w: the visible point of the floor in radii, with w > 0 in front of the eye.
Eigen::Matrix3d floor_from_device(const Camera& camera, double radius);

}  // namespace twrench::picture
