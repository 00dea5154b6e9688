#pragma once

#include <twrench/body/shape.h>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <tuple>

#include "mesh/mesh_file.h"
#include "scene/scene.h"

namespace twrench::scene {

/// The meshes of a scene file, each of which is read once, however many parts are made of it.
class MeshFiles {
 public:
  /// A mesh as a part has it, where it is from, and what was put right.
  struct Entry {
    body::Mesh shape;
    MeshSource source;
    std::vector<std::string> notes;
  };

  /// Those of a scene file, whose paths start from the folder that it is in. Where there is no such
  /// file, its name may be that of a built-in mesh.
  static MeshFiles beside(const std::string& scene_file);

  /// Those of a built-in scene, which are built in too.
  static MeshFiles built_in() { return MeshFiles(std::nullopt); }

  /// Reads a mesh. Throws InvalidArgument about the mesh, and FileError. A short scene file must
  /// not take minutes because it reads a mesh a thousand times, each time in another size.
  const Entry& read(const std::string& file, const mesh::ReadOptions& options);

 private:
  using Key = std::tuple<std::string, std::optional<double>, double, double>;

  explicit MeshFiles(std::optional<std::filesystem::path> folder) : folder_(std::move(folder)) {}

  Entry load(const std::string& file, const mesh::ReadOptions& options) const;

  std::optional<std::filesystem::path> folder_;  ///< Nothing for a built-in scene.
  std::map<Key, Entry> entries_;
  std::size_t repeated_triangles_ = 0;  ///< Of files that were read once more.
};

}  // namespace twrench::scene
