// Meshes in all formats. The first byte, a digit in the corpus, selects the name of the file.
#include <twrench/base/error.h>

#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include "mesh/mesh_file.h"
#include "system/error.h"
#include "target.h"

namespace {

using namespace twrench;

constexpr std::array names{"a.obj", "a.stl", "a.ply", "a.gltf", "a.glb", "a.dae", "a.3mf"};

void read(std::string_view bytes, const std::string& name, const mesh::ReadOptions& options) {
  const mesh::MeshFile file = mesh::read_mesh(bytes, name, options);
  const body::TriangleMesh& surface = *file.shape.surface;
  require(!surface.triangles.empty(), "there are triangles");
  require(surface.colors.empty() || surface.colors.size() == surface.vertices.size(),
          "each vertex has a colour or none has");
  for (const auto& triangle : surface.triangles) {
    for (const std::uint32_t corner : triangle) {
      require(corner < surface.vertices.size(), "corners are there");
      require(surface.vertices[corner].allFinite(), "coordinates are finite");
    }
  }
  require(file.shape.integrals.volume >= 0 && std::isfinite(file.shape.integrals.volume),
          "a body has a volume");
  require(options.shell > 0 || file.open_edges == 0, "a solid is closed");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  const std::string name = names[data[0] % 16U % names.size()];
  for (const mesh::ReadOptions& options :
       {mesh::ReadOptions{.scale = 1.0}, mesh::ReadOptions{.scale = 0.1, .weld = 1e-3},
        mesh::ReadOptions{.scale = 1.0, .shell = 0.1}}) {
    try {
      read(bytes, name, options);
    } catch (const InvalidArgument&) {
    } catch (const system::FileError&) {
    }
  }
  return 0;
}
