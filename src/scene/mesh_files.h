#pragma once

#include <twrench/body/shape.h>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "mesh/mesh_file.h"
#include "scene/scene.h"

namespace twrench::scene {

/// The shape of a mesh, its source, and the repairs that were made to it.
struct MeshEntry {
  body::Mesh shape;
  MeshSource source;
  std::vector<std::string> notes;
};

/// Returns the entry of a mesh that was read from `path`, or from memory if that is empty; `file`
/// is its name as it was given.
MeshEntry mesh_entry(mesh::MeshFile mesh, const std::string& file,
                     const std::filesystem::path& path, const mesh::ReadOptions& options);

/// The files that a scene file names: its meshes, its sounds and its recording. Each mesh is read
/// once, even if several parts use it.
class MeshFiles {
 public:
  /// The meshes of a scene file, with paths relative to its folder. If there is no such file, the
  /// name may be that of a built-in mesh.
  static MeshFiles beside(const std::string& scene_file);

  /// The meshes of a built-in scene, which are also built in.
  static MeshFiles built_in() { return MeshFiles(std::nullopt); }

  /// Reads a mesh. Throws FileError, and InvalidArgument if the mesh is invalid or if too many
  /// triangles are read again with other options: a short scene file must not take minutes.
  const MeshEntry& read(const std::string& file, const mesh::ReadOptions& options);

  /// Returns the sound file with that path from the folder of the scene file, without reading it.
  SoundFile sound(const std::string& file) const { return {file, path_of(file)}; }

  /// Returns the path of a file that the scene file names.
  std::filesystem::path path_of(const std::string& file) const {
    return folder_.value_or(std::filesystem::path()) / file;
  }

 private:
  using Key = std::tuple<std::string, std::optional<double>, double, double>;

  explicit MeshFiles(std::optional<std::filesystem::path> folder) : folder_(std::move(folder)) {}

  MeshEntry load(const std::string& file, const mesh::ReadOptions& options) const;

  std::optional<std::filesystem::path> folder_;  ///< Nothing for a built-in scene.
  std::map<Key, MeshEntry> entries_;
  std::size_t repeated_triangles_ = 0;  ///< Triangles of files that were read again.
};

}  // namespace twrench::scene
