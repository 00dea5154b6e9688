#pragma once

#include <twrench/body/shape.h>

#include <optional>
#include <span>

#include "picture/body/mesh.h"

namespace twrench::page {

/// How many triangles the parts that are given by triangles have, and how many of them are drawn;
/// of walls, on both sides.
struct Simplification {
  std::size_t given, drawn;
};

/// Takes triangles, and the vertices that only they use, out of those parts of a body's mesh that
/// are given by triangles, until about `most` are left: the triangles whose absence changes the
/// shape least (Garland and Heckbert, "Surface Simplification Using Quadric Error Metrics",
/// SIGGRAPH 97). A surface too rough for that is cut into cells with a vertex each. A small part
/// beside large ones keeps 100. Does and returns nothing where there are no more than `most`;
/// clusters are not kept.
std::optional<Simplification> simplify(picture::Mesh& mesh, std::span<const body::Part> parts,
                                       std::size_t most);

}  // namespace twrench::page
