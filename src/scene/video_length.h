#pragma once

#include <string>

#include "scene/scene.h"

namespace twrench::scene {

/// The value of a scene that stays when its video gets another length; the other one follows.
enum class Kept {
  speed,     ///< Film::speed: the motion is cut or extended.
  duration,  ///< Motion::duration: it is shown faster or slower.
};

/// Makes the video of a scene `length` s long. The duration and the speed are then values that the
/// user gave. Throws InvalidArgument about `what` if the scene has shots, each of which has its own
/// length, or if the length or the value that follows from it is not allowed.
void set_video_length(Scene& scene, double length, Kept kept, const std::string& what);

/// Describes the times of a video: "6 s of motion, 4.6 times as fast: 1.3 s of video", or
/// "3 shots: 12 s of video".
std::string describe_video(const Scene& scene);

}  // namespace twrench::scene
