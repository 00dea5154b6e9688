#include "mesh/diagnosis.h"

#include <fmt/format.h>

#include <utility>

#include "mesh/mesh_file.h"

namespace twrench::mesh {
namespace {

using body::TriangleMesh;
using Eigen::Vector3d;

std::string text_of(const Vector3d& point) {
  return fmt::format("({:.9g}, {:.9g}, {:.9g})", point.x(), point.y(), point.z());
}

/// "12 edges ..., the first from (0, 0, 0) to (0, 0, 1)".
std::string edges_text(const TriangleMesh& mesh, const std::vector<DirectedEdge>& edges) {
  const auto& [from, to] = edges.front();
  return fmt::format("{} edge{}, the first from {} to {}", edges.size(),
                     edges.size() == 1 ? "" : "s", text_of(mesh.vertices[from]),
                     text_of(mesh.vertices[to]));
}

}  // namespace

void require_solid(const std::string& name, TriangleMesh& mesh, const Topology& topology,
                   double /*scale*/, std::vector<std::string>& /*notes*/) {
  if (!topology.open.empty()) {
    throw MeshError(MeshError::Reason::open, name,
                    "the surface is open at " + edges_text(mesh, topology.open),
                    "close it, or make it a wall: shell = THICKNESS, in cm");
  }
}

}  // namespace twrench::mesh
