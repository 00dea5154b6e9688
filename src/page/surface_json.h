#pragma once

#include <nlohmann/json_fwd.hpp>

#include "page/materials.h"
#include "page/surface.h"

namespace twrench::page {

/// Returns the surface of a body as web/picture/surface.js reads it. Vertices are six 16-bit
/// integers, with positions in units of radius / 32767 and normals in units of 1 / 32767; indices
/// have 32 bits; the colours of vertices, if there are any, are linear 16-bit integers. All of
/// these are packed(). Also has the index ranges and the material of each part, and the numbers
/// from which the core computes uniforms.
nlohmann::ordered_json surface_json(const scene::Scene& scene, const Surface& surface,
                                    const Materials& materials);

}  // namespace twrench::page
