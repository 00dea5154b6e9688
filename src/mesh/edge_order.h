#pragma once

#include <twrench/body/triangle_mesh.h>

#include <cstdint>
#include <span>

namespace twrench::mesh {

/// A triangle at an edge: its third vertex, and whether it runs along the edge from its first end
/// to its second.
struct EdgeTriangle {
  std::uint32_t vertex;
  bool is_forward;
};

/// Returns whether closed surfaces that touch along an edge bound a solid there: whether, on a way
/// around the edge, each triangle that leads into the solid is followed by one that leads out of
/// it. Triangles that lie on each other may follow in any order. False if the solid would count
/// twice between some of the triangles, if some are turned over, or if a triangle has no area. Both
/// directions must have the same number of triangles.
bool bounds_solid(const body::TriangleMesh& mesh, std::uint32_t from, std::uint32_t to,
                  std::span<const EdgeTriangle> triangles);

}  // namespace twrench::mesh
