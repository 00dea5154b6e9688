#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "picture/body/mesh.h"

namespace twrench::picture {

/// Triangles between the vertices of a mesh, with the same winding.
struct Facets {
  /// Three per triangle.
  std::vector<std::uint32_t> indices;
  /// In indices, the end of each part.
  std::vector<std::size_t> part_ends;
  /// In indices, where the triangles of a cylinder's side begin in its part.
  std::vector<std::size_t> side_begins;
  /// Largest depth in cm of a facet below the mesh's own.
  double depth = 0;
};

/// Returns the visible facets of the mesh as seen from `eye` (cm, body axes). They are merged into
/// fewer triangles, because a software rasteriser pays for whole blocks of pixels along each edge.
/// On the side of a cylinder, up to four strips are merged into one, and fewer close to the
/// silhouette, which is unchanged; strips that face away are omitted. The visible surface has no
/// gaps. A wide facet lies deep inside the cylinder, but the shader computes the shading from the
/// exact cylinder. If a part is given by triangles, those that face the eye (`faces_eye`, one value
/// per triangle) are returned cluster by cluster, the nearest first: triangles that they hide are
/// then not shaded.
Facets visible_facets(const Mesh& mesh, const glm::vec3& eye, std::span<const char> faces_eye);

}  // namespace twrench::picture
