#pragma once

#include "gl/backend.h"
#include "robot/report.h"

namespace twrench::film {

/// Draws the links that are not good, before and after the repair: the worst ones, because
/// thousands of pictures would take hours and make a page that no browser shows. Throws GlError.
robot::RobotPictures robot_pictures(const robot::JudgedRobot& judged, const robot::Repair& repair,
                                    const gl::BackendChoice& backend);

}  // namespace twrench::film
