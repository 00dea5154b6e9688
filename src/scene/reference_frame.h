#pragma once

#include <twrench/motion/rotating_frame.h>

#include "scene/scene.h"

namespace twrench::scene {

/// Returns the scene's frame of reference at the time of a sample of the motion.
motion::RotatingFrame reference_frame(Frame frame, const motion::FreeBody& body,
                                      const motion::Sample& sample);

}  // namespace twrench::scene
