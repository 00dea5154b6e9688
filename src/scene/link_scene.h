#pragma once

#include <string>

#include "robot/diagnosis.h"
#include "scene/scene.h"

namespace twrench::scene {

/// Returns the index of a link. Throws InvalidArgument about `what`, with the nearest name, if
/// there is none.
std::size_t link_index(const robot::Robot& robot, const std::string& link, const std::string& what);

/// Returns the body of a robot's link: it moves by the mass properties of the file, and is drawn as
/// the link's geometry. Throws InvalidArgument about the link if it has no mass properties, or none
/// that a body can move by.
Body link_body(const robot::JudgedRobot& judged, std::size_t link);

/// The same with other mass properties than those of the file.
Body link_body(const robot::JudgedRobot& judged, std::size_t link, const robot::LinkMass& mass);

}  // namespace twrench::scene
