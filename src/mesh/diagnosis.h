#pragma once

#include <string>
#include <vector>

#include "mesh/topology.h"

namespace twrench::mesh {

/// Turns a mesh that is inside out, and says so in a note. Throws MeshError or InvalidArgument
/// about `name` where the mesh bounds no solid. `scale` is the length of its unit in cm. Without
/// `search`, crossing triangles and components within each other are not found.
void require_solid(const std::string& name, body::TriangleMesh& mesh, const Topology& topology,
                   double scale, bool search, std::vector<std::string>& notes);

}  // namespace twrench::mesh
