#pragma once

#include <twrench/body/mass_properties.h>
#include <twrench/motion/stability.h>

#include <cstddef>
#include <string>

#include "scene/scene.h"

namespace twrench::scene {

/// Returns the name of the principal axis with that index: that of the body axis with which it
/// coincides, or else I1, I2 or I3.
std::string axis_name(const Eigen::Matrix3d& axes, int axis);

/// Returns the unit vector of that name in body axes: of x, y or z in the positive direction.
Eigen::Vector3d named_axis(const Eigen::Matrix3d& axes, int axis);

/// Returns "least", "middle" or "greatest", the name of a principal axis by the rank of its moment,
/// from 0 to 2.
std::string rank_name(std::size_t rank, Language language);

/// Describes the course of a small tilt of a rotation at `omega` rad/s, such as "doubles every 1.88
/// s at 1 rad/s"; empty if it neither grows nor oscillates.
std::string course_of_tilt(const motion::Stability& stability, double omega, Language language);

/// Describes the effect of a small tilt on a body that rotates about a principal axis at `omega`
/// rad/s, such as "unstable about x, doubles every 1.88 s at 1 rad/s".
std::string prediction(const body::PrincipalAxes& principal, body::PrincipalAxes::Axis axis,
                       double omega, Language language = Language::en);

}  // namespace twrench::scene
