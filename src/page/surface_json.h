#pragma once

#include <nlohmann/json.hpp>

#include "page/materials.h"
#include "page/surface.h"

namespace twrench::page {

/// Returns the surface of a body as web/picture/surface.js reads it: vertices of six 16-bit
/// integers, of which the position is in units of radius / 32767 and the normal of 1 / 32767, and
/// indices of 32 bits; the colours of vertices, if there are any, as 16-bit integers, linear; all
/// of these packed(); the index ranges and the material of each part; and the numbers from which
/// the core computes uniforms.
nlohmann::ordered_json surface_json(const scene::Scene& scene, const Surface& surface,
                                    const Materials& materials);

}  // namespace twrench::page
