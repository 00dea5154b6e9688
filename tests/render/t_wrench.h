#pragma once

#include "body/shape.h"
#include "scene/scene.h"

namespace twrench {

/// A cylinder along `axis`.
inline Part cylinder(double radius, double length, const Eigen::Vector3d& position,
                     const Eigen::Vector3d& axis) {
  return {Cylinder{radius, length}, 6.7, position, frame_with_z_along(axis)};
}

/// The T-wrench of the specification, in small frames.
inline Scene t_wrench(int width = 160, int height = 90) {
  Scene scene;
  scene.body.parts = {cylinder(1, 8, {-1, 0, 0}, Eigen::Vector3d::UnitY()),
                      cylinder(1, 4, {2, 0, 0}, Eigen::Vector3d::UnitX())};
  scene.film.width = width;
  scene.film.height = height;
  return scene;
}

}  // namespace twrench
