#pragma once

#include <string>

#include "picture/look/material.h"
#include "picture/look/studio.h"

namespace twrench::picture {

/// GLSL: what the body is made of and the studio's lights, as constants. They are the same in every
/// frame, and a software rasteriser pays for each uniform at every pixel: as constants the lights
/// cost a third (docs/performance-notes.md).
std::string shader_constants(const Material& material, const Studio& studio);

}  // namespace twrench::picture
