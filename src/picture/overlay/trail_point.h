#pragma once

#include <Eigen/Core>

#include "scene/scene.h"

namespace twrench::picture {

/// Returns the point of the body that draws the trail, in body axes from the centre of mass, cm:
/// the scene's or, by default, a point just outside the end of a part. Of the ends of parts along
/// their axes, of meshes along their principal axes, it is the farthest one that has no mirror
/// image at the same distance, such as the tip of the T-wrench's leg; if all have one, it is the
/// farthest of all.
Eigen::Vector3d trail_point(const scene::Scene& scene);

}  // namespace twrench::picture
