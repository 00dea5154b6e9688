#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robot/diagnosis.h"

namespace twrench::robot {

/// Returns the mass properties with which a simulator computes: those of the geometries if they
/// determine them, otherwise the stated ones; of an MJCF file with the changes that MuJoCo's
/// compiler makes, in the frames of the file. A link without mass properties has zeros. Nothing for
/// a link whose geometries are unknown. `geometries` are those of the links.
std::vector<std::optional<LinkMass>> compiled(const Robot& robot,
                                              const std::vector<LinkGeometry>& geometries);

/// Returns one line about each stated inertia that MuJoCo's compiler changes because of a setting,
/// so that it hides a fault, and about a change of all masses.
std::vector<std::string> hidden_faults(const Robot& robot);

}  // namespace twrench::robot
