#include "mesh/gltf_sizes.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include <algorithm>
#include <cstddef>

#include "mesh/gltf_accessor.h"

namespace twrench::mesh {
namespace {

std::uint64_t triangles_of(GltfMode mode, std::uint64_t corners) {
  if (mode == GltfMode::triangles) return corners / 3;
  return corners < 3 ? 0 : corners - 2;
}

void count(const GltfValue& document, const GltfValue& primitive, GltfBuffers& buffers,
           GltfMesh& mesh) {
  mesh.has_targets = mesh.has_targets || primitive.find("targets");
  const std::uint64_t mode = primitive.whole_or("mode", 4);
  if (mode > 6) throw primitive.at("mode").bad("is no kind of primitive");
  if (mode < 4) {
    ++mesh.points_and_lines;
    return;
  }
  const auto size = [&](const GltfValue& index) {
    return GltfAccessor(document.at("accessors").at(index.whole()), buffers).size();
  };
  const std::size_t vertices = size(primitive.at("attributes").at("POSITION"));
  const auto indices = primitive.find("indices");
  const std::uint64_t triangles = triangles_of(GltfMode(mode), indices ? size(*indices) : vertices);
  if (triangles == 0) return;
  mesh.vertices += vertices;
  mesh.triangles += triangles;
  mesh.primitives.push_back({primitive, GltfMode(mode)});
}

GltfMesh counted(const GltfValue& document, std::uint64_t index, GltfBuffers& buffers) {
  GltfMesh mesh;
  const GltfValue primitives = document.at("meshes").at(index).at("primitives");
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    count(document, primitives.at(i), buffers, mesh);
  }
  return mesh;
}

}  // namespace

std::map<std::uint64_t, GltfMesh> gltf_meshes(const Source& source, const GltfValue& document,
                                              const std::vector<GltfInstance>& instances,
                                              GltfBuffers& buffers) {
  std::map<std::uint64_t, GltfMesh> meshes;
  for (const GltfInstance& instance : instances) {
    if (meshes.contains(instance.mesh)) continue;
    meshes.emplace(instance.mesh, counted(document, instance.mesh, buffers));
  }
  // Without repetition, a triangle takes at least one byte.
  constexpr std::uint64_t repeated = 3'000'000;
  const std::uint64_t most =
      std::max<std::uint64_t>(source.bytes.size() + buffers.bytes(), repeated);
  std::uint64_t vertices = 0, triangles = 0;
  for (const GltfInstance& instance : instances) {
    vertices += meshes.at(instance.mesh).vertices;
    triangles += meshes.at(instance.mesh).triangles;
    if (triangles <= most && vertices <= 3 * most) continue;
    throw InvalidArgument(source.name,
                          fmt::format("its nodes repeat its meshes to more than {} triangles, or "
                                      "{} vertices",
                                      most, 3 * most),
                          "remove repeated nodes, or save each mesh as often as it is there");
  }
  return meshes;
}

}  // namespace twrench::mesh
