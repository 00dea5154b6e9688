#pragma once

#include <Eigen/Geometry>

#include "robot/robot.h"
#include "robot/xml_file.h"

namespace twrench::robot {

/// Returns the rotation by roll, pitch and yaw in rad about the fixed axes x, y and z, in this
/// order: Rz(yaw) Ry(pitch) Rx(roll).
Eigen::Matrix3d rotation_from_rpy(const Eigen::Vector3d& rpy);

/// Returns the length in cm, which is how shapes have it. Throws InvalidArgument about the element
/// unless it is positive and finite.
double length_in_cm(const XmlFile& file, const pugi::xml_node& node, double metres);

// The readers of the formats. Each throws InvalidArgument about a place in the file, and adds a
// note about what it skips.

void read_urdf(const XmlFile& file, Robot& robot);

}  // namespace twrench::robot
