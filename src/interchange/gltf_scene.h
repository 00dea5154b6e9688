#pragma once

#include <string>

#include "interchange/gltf.h"
#include "scene/scene.h"

namespace twrench::interchange {

/// Options of an animation.
struct AnimationOptions {
  /// Bound in rad for the angle between the animation, at any instant, and the exact motion.
  double max_angle = 1e-4;
  /// Seconds of motion per second of the animation.
  double speed = 1;
};

/// Returns the scene as a glTF document with one animation of its exact motion, whatever the
/// scene's method. Its nodes are the camera, carried by a rotating node if it orbits; the body,
/// whose children are its parts and its axes; L; and omega. Space is that of the scene, y up, in
/// metres. `generator` is the program's name and version.
///
/// The body turns. The arrow of omega turns and is scaled by |omega| over its initial value; the
/// arrow of L does neither. For a body at rest both arrows are absent. The errors of the attitude
/// and of the direction of omega are at most max_angle, and so is the relative error of the length
/// of omega, as key_times() describes.
///
/// Throws as key_times() does.
Gltf gltf_scene(const scene::Scene& scene, const AnimationOptions& options,
                const std::string& generator);

}  // namespace twrench::interchange
