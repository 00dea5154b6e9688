#pragma once

#include <string>

#include "picture/look/material.h"
#include "picture/look/studio.h"

namespace twrench::picture {

/// Returns GLSL constants for the body's material and the studio's lights. They are the same in
/// every frame, and a software rasteriser pays for each uniform at every pixel: as constants the
/// lights cost a third (docs/performance-notes.md).
std::string shader_constants(const Material& material, const Studio& studio);

}  // namespace twrench::picture
