#pragma once

#include <twrench/body/shape.h>

#include "scene/scene.h"

namespace twrench::picture {

/// A cylinder along `axis`.
inline body::Part cylinder(double radius, double length, const Eigen::Vector3d& position,
                           const Eigen::Vector3d& axis) {
  return {body::Cylinder{radius, length}, 6.7, position, body::frame_with_z_along(axis)};
}

/// The T-wrench of the specification, in small frames.
inline scene::Scene t_wrench(int width = 160, int height = 90) {
  scene::Scene scene;
  scene.body.parts = {cylinder(1, 8, {-1, 0, 0}, Eigen::Vector3d::UnitY()),
                      cylinder(1, 4, {2, 0, 0}, Eigen::Vector3d::UnitX())};
  scene.film.width = width;
  scene.film.height = height;
  return scene;
}

}  // namespace twrench::picture
