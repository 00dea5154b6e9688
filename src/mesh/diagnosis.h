#pragma once

#include <string>
#include <vector>

#include "mesh/topology.h"

namespace twrench::mesh {

/// Turns a mesh over if it is inside out, and adds a note about it. Throws MeshError or
/// InvalidArgument about `name` if the mesh does not bound a solid. `scale` is the length of its
/// unit in cm. Without `search`, crossing triangles and nested components are not detected.
void require_solid(const std::string& name, body::TriangleMesh& mesh, const Topology& topology,
                   double scale, bool search, std::vector<std::string>& notes);

}  // namespace twrench::mesh
