#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robot/diagnosis.h"

namespace twrench::robot {

/// Returns the mass properties with which a simulator computes: those of the geometries for links
/// that say so, otherwise the stated ones, after the changes that MuJoCo's compiler makes. Those of
/// a link without any are zero. Nothing for a link whose geometries are not known. `geometries` are
/// those of the links.
std::vector<std::optional<LinkMass>> compiled(const Robot& robot,
                                              const std::vector<LinkGeometry>& geometries);

/// Returns one line about each stated inertia and each setting with which MuJoCo's compiler hides
/// that the stated values are impossible, or changes them.
std::vector<std::string> hidden_faults(const Robot& robot);

}  // namespace twrench::robot
