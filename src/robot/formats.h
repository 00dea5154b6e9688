#pragma once

#include <Eigen/Geometry>

#include "robot/robot.h"
#include "robot/xml_file.h"

namespace twrench::robot {

/// The density in kg/m^3 of geometries for which an SDF or MJCF file states none.
inline constexpr double default_density = 1000.0;

/// Returns the rotation by roll, pitch and yaw in rad about the fixed axes x, y and z, in this
/// order: Rz(yaw) Ry(pitch) Rx(roll).
Eigen::Matrix3d rotation_from_rpy(const Eigen::Vector3d& rpy);

/// Returns the rotation of a quaternion of any length. Throws InvalidArgument about the element if
/// it is zero or not finite.
Eigen::Matrix3d rotation_from_quaternion(const XmlFile& file, const pugi::xml_node& node,
                                         const Eigen::Quaterniond& quaternion);

/// Returns the length in cm, which is how shapes have it. Throws InvalidArgument about the element
/// unless it is positive and neither too large nor too small.
double length_in_cm(const XmlFile& file, const pugi::xml_node& node, double metres);

// The readers of the formats. Each throws InvalidArgument about a place in the file, and adds a
// note about what it skips.

void read_urdf(const XmlFile& file, Robot& robot);
void read_sdf(const XmlFile& file, Robot& robot);
void read_mjcf(const XmlFile& file, Robot& robot);

}  // namespace twrench::robot
