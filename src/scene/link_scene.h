#pragma once

#include <cstddef>

#include "robot/diagnosis.h"
#include "scene/scene.h"

namespace twrench::scene {

/// Returns the body of a robot's link: it moves by the mass properties of the file, and is drawn as
/// the link's geometry. Throws InvalidArgument about the link if it has no mass properties, or none
/// that a body can move by.
Body link_body(const robot::JudgedRobot& judged, std::size_t link);

/// The same with other mass properties than those of the file.
Body link_body(const robot::JudgedRobot& judged, std::size_t link, const robot::LinkMass& mass);

}  // namespace twrench::scene
