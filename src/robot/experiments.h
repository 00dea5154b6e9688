#pragma once

#include <optional>
#include <vector>

#include "robot/diagnosis.h"

namespace twrench::robot {

/// Returns the relative error that the digits of a matrix allow, at least 0.1 %, because the
/// geometry is often a simplified one, and at most 2 %.
double relative_resolution(const Inertial& inertial);

/// Returns the greatest difference of a link's moments and products from those of a geometry with
/// its mass, relative to the greatest moment of the geometry.
double misfit_of(const LinkMass& body, const MassModel& model);

/// Returns the geometry of uniform density that has the link's moments within the digits of the
/// file; nothing if none has.
std::optional<Agreement> agreement(const Inertial& inertial, const std::vector<MassModel>& models);

/// Undoes each mistake in turn, and returns those without which the moments are those of a geometry
/// or, if there is no such geometry and the moments are impossible, those without which they are
/// possible.
std::vector<Finding> mistakes(const Inertial& inertial, const std::vector<MassModel>& models,
                              const Diagnosis& diagnosis);

}  // namespace twrench::robot
