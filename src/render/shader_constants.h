#pragma once

#include <string>

#include "render/material.h"
#include "render/studio.h"

namespace twrench {

/// Returns the material and the studio's lights as GLSL constants. They are the same in every
/// frame, and a software rasteriser reads each uniform for every pixel: as constants the lights
/// cost a third (docs/performance.md).
std::string shader_constants(const Material& material, const Studio& studio);

}  // namespace twrench
