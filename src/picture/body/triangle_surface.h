#pragma once

#include <twrench/body/shape.h>

#include <Eigen/Core>

#include "picture/body/mesh.h"

namespace twrench::picture {

/// Returns the surface of a part that is given by triangles, at `position` cm and turned by
/// `body_from_part`, as a mesh of one part. Vertices in one place are joined. Adjacent triangles
/// that meet at no more than `crease_angle` rad share normals: the mean of the normals of the
/// triangles around, each weighted by its angle there (Thürmer and Wüthrich, "Computing Vertex
/// Normals from Polygonal Facets", Journal of Graphics Tools 3 (1998)). Degenerate triangles are
/// omitted. A wall has a second side: the same triangles turned over. Facets deviate from the given
/// triangles by at most `tolerance` cm, see decimate(); 0 keeps them all.
Mesh triangle_surface(const body::Mesh& mesh, const Eigen::Vector3d& position,
                      const Eigen::Matrix3d& body_from_part, double tolerance, double crease_angle);

}  // namespace twrench::picture
