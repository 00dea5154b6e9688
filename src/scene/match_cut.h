#pragma once

#include "scene/scene.h"

namespace twrench::scene {

/// Returns the time in s, from 0 to `duration`, of the motion of `shot` at which the body is seen
/// in the attitude nearest to that in which it is seen at the end of the shot `last`; the earliest
/// of several that are equally near. Both must show one body. Throws as motion::integrate() does.
double match_time(const Scene& shot, double duration, const Shot& last);

}  // namespace twrench::scene
