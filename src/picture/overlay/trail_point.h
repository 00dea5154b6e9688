#pragma once

#include <Eigen/Core>

#include "scene/scene.h"

namespace twrench::picture {

/// Returns the point of the body that draws the trail, in body axes from the centre of mass, cm. It
/// is the scene's or, by default, a point just outside the end of a part. Parts have ends along
/// their axes, meshes along their principal axes. The default is the farthest end that has no
/// mirror image at the same distance, such as the tip of the T-wrench's leg; if all have one, it is
/// the farthest of all.
Eigen::Vector3d trail_point(const scene::Scene& scene);

}  // namespace twrench::picture
