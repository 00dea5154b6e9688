#pragma once

#include <Eigen/Core>

#include "scene/scene.h"

namespace twrench {

/// The point of the body whose trail is drawn, in body axes from the centre of mass, cm: the
/// scene's or, where it names none, just outside the end of a part: of those ends (of cylinders,
/// boxes and ellipsoids, along their axes) that no other mirrors at the same distance the farthest,
/// as the tip of the T-wrench's leg; where all have their like, the farthest of all.
Eigen::Vector3d trail_point(const Scene& scene);

}  // namespace twrench
