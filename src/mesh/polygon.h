#pragma once

#include <twrench/body/triangle_mesh.h>

#include <cstdint>
#include <span>

namespace twrench::mesh {

/// Adds the triangles of a polygon, which share its first corner.
void add_polygon(std::span<const std::uint32_t> ring, body::TriangleMesh& mesh);

}  // namespace twrench::mesh
