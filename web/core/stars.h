#pragma once

#include <vector>

#include "picture/space/camera.h"

namespace twrench::page {

/// Returns stars all around, five numbers each: the direction in space, the brightness from 0 to 1
/// and the tint, a factor of green. In the picture of `home` they are the `count` stars of the
/// film's still background (src/picture/look/background.cpp); outside of it, stars of the same
/// brightness are spread evenly.
std::vector<float> stars_around(const picture::Camera& home, int count);

}  // namespace twrench::page
