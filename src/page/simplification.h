#pragma once

#include <twrench/body/shape.h>

#include <optional>
#include <span>

#include "picture/body/mesh.h"

namespace twrench::page {

/// The number of triangles of the parts that are given as triangles, and the number of them that
/// are drawn; walls count on both sides.
struct Simplification {
  std::size_t given, drawn;
};

/// Removes triangles, and the vertices that only they use, from the parts of a body's mesh that are
/// given as triangles, until about `most` are left. It removes those whose absence changes the
/// shape least (Garland and Heckbert, "Surface Simplification Using Quadric Error Metrics",
/// SIGGRAPH 97). A surface too rough for that is divided into cells with one vertex each. A small
/// part beside large ones keeps 100. Changes nothing and returns nothing if there are at most
/// `most`; clusters are not kept.
std::optional<Simplification> simplify(picture::Mesh& mesh, std::span<const body::Part> parts,
                                       std::size_t most);

}  // namespace twrench::page
