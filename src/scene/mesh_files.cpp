#include "scene/mesh_files.h"

#include <twrench/base/error.h>

#include <algorithm>
#include <iterator>
#include <system_error>
#include <utility>
#include <vector>

#include "base/words.h"
#include "embedded/meshes.h"

namespace twrench::scene {
namespace {

namespace fs = std::filesystem;

mesh::MeshFile read_built_in(const std::string& name, const mesh::ReadOptions& options) {
  const auto& meshes = embedded::meshes();
  const auto found = meshes.find(name);
  if (found != meshes.end()) return mesh::read_mesh(found->second, name, options);
  std::vector<std::string> names;
  std::ranges::transform(meshes, std::back_inserter(names),
                         [](const auto& mesh) { return std::string(mesh.first); });
  throw unknown_name("mesh", name, names);
}

}  // namespace

MeshEntry mesh_entry(mesh::MeshFile mesh, const std::string& file, const fs::path& path,
                     const mesh::ReadOptions& options) {
  return {std::move(mesh.shape),
          {.file = file,
           .path = path,
           .others = std::move(mesh.others),
           .scale = options.scale,
           .weld = options.weld,
           .sha256 = std::move(mesh.sha256)},
          std::move(mesh.notes)};
}

MeshFiles MeshFiles::beside(const std::string& scene_file) {
  return MeshFiles(fs::path(scene_file).parent_path());
}

const MeshEntry& MeshFiles::read(const std::string& file, const mesh::ReadOptions& options) {
  const Key key{file, options.scale, options.weld, options.shell};
  const auto found = entries_.find(key);
  if (found != entries_.end()) return found->second;
  const auto is_read = [&](bool with_this_weld) {
    return std::ranges::any_of(entries_, [&](const auto& entry) {
      const auto& [other, scale, weld, shell] = entry.first;
      return other == file && (!with_this_weld || (weld == options.weld && shell == 0.0));
    });
  };
  mesh::ReadOptions once_more = options;
  once_more.search = options.shell == 0.0 && !is_read(true);
  const bool is_repeated = is_read(false);
  const MeshEntry& entry = entries_.emplace(key, load(file, once_more)).first->second;
  constexpr std::size_t search_factor = 10;  // a search takes this much longer
  const std::size_t triangles = entry.shape.surface->triangles.size();
  if (is_repeated) repeated_triangles_ += triangles * (once_more.search ? search_factor : 1);
  constexpr std::size_t most_repeated = 1'000'000;
  if (repeated_triangles_ <= most_repeated) return entry;
  throw InvalidArgument(file,
                        "the parts of the scene read it too often with other values of scale, "
                        "weld and shell",
                        "give parts of one mesh the same values, or use a mesh of fewer triangles");
}

MeshEntry MeshFiles::load(const std::string& file, const mesh::ReadOptions& options) const {
  std::error_code failed;
  const fs::path path = folder_.value_or(fs::path()) / file;
  const bool is_built_in =
      !folder_ || (embedded::meshes().contains(file) && !fs::exists(path, failed));
  if (is_built_in) return mesh_entry(read_built_in(file, options), file, {}, options);
  return mesh_entry(mesh::read_mesh(path, options), file, path, options);
}

}  // namespace twrench::scene
