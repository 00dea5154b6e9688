#pragma once

#include <Eigen/Core>
#include <span>

#include "picture/space/camera.h"
#include "scene/scene.h"

namespace twrench::picture {

/// Returns the framing, as seen from the scene's camera at the start of the video, that keeps the
/// sphere of `radius` cm about the origin and the `points` (space, cm) in view along the camera's
/// whole orbit, at the scene's distance. `aspect` is the picture's width / height.
Framing framing_along(const scene::Scene& scene, double aspect, double radius,
                      std::span<const Eigen::Vector3d> points);

}  // namespace twrench::picture
