// Scenes from TOML. Keys, units and defaults are documented in docs/scene-files.md.
#include <fmt/format.h>
#include <twrench/base/error.h>

#include <filesystem>
#include <system_error>

#include "base/words.h"
#include "embedded/scenes.h"
#include "scene/fields.h"
#include "scene/keys.h"
#include "scene/mesh_files.h"
#include "scene/mesh_scene.h"
#include "scene/natural_times.h"
#include "scene/recording_table.h"
#include "scene/scene.h"
#include "scene/scene_tables.h"
#include "scene/shot_tables.h"
#include "system/file.h"
#include "system/file_kind.h"

namespace twrench::scene {
namespace {

bool has_ending_of_scenes(const std::string& path) {
  return to_lower(std::filesystem::path(path).extension().string()) == ".toml";
}

/// Marks the values set so far as given by the scene instead of the user.
void mark_as_of_scene(Scene& scene) {
  for (const auto member : all_origins) {
    Origin& origin = scene.origins.*member;
    if (origin == Origin::user) origin = Origin::scene;
  }
}

constexpr const char* files_of_scenes =
    "name a scene file, .toml, or a mesh: .obj .stl .ply .gltf .glb .dae .3mf";

/// Throws InvalidArgument if the file is of another kind, or in UTF-16.
void require_text(std::string_view text, const std::string& file) {
  const auto kind = system::recognized_file_kind(text);
  if (!kind || text.empty()) return;
  throw InvalidArgument(file, fmt::format("it is {}", *kind), files_of_scenes);
}

Scene parse(std::string_view text, const std::string& source, MeshFiles meshes) {
  const std::string remedy = has_ending_of_scenes(source) ? "" : files_of_scenes;
  const toml::table root = parse_toml(text, source, remedy);
  Scene scene;
  scene.name = std::filesystem::path(source).stem().string();
  TomlTable file(root, source, "");
  read_fields(file, "", scene);
  scene.body = read_body(file, meshes);
  for (const std::string& name : field_tables()) {
    file.table(name, [&](TomlTable& table) {
      read_fields(table, name, scene);
      if (name == "motion") scene.motion.recording_file = read_recording_file(table, meshes);
    });
  }
  if (scene.film.audio.is_given()) scene.film.audio = meshes.sound(scene.film.audio.file);
  require_interior(file, scene);
  mark_as_of_scene(scene);
  set_natural_times(scene);
  read_shots(file, scene, meshes);
  if (scene.motion.recording_file && !scene.shots.empty()) {
    throw InvalidArgument(file.place("motion", recording_file_key),
                          "each shot has its own motion, and this one is recorded",
                          "leave out the shots, or the recording");
  }
  file.finish();
  return scene;
}

}  // namespace

Scene parse_scene(std::string_view text, const std::string& source) {
  return parse(text, source, MeshFiles::beside(source));
}

std::vector<std::string> builtin_scene_names() {
  std::vector<std::string> names;
  for (const std::string_view file : embedded::scenes_in_order()) {
    names.push_back(std::filesystem::path(file).stem().string());
  }
  return names;
}

bool is_scene_file(const std::string& name_or_path) {
  std::error_code none;
  const bool is_builtin = embedded::scenes().contains(name_or_path + ".toml");
  return has_ending_of_scenes(name_or_path) || mesh::is_mesh_name(name_or_path) ||
         name_or_path.find('/') != std::string::npos ||
         (!is_builtin && std::filesystem::exists(name_or_path, none));
}

Scene load_scene(const std::string& name_or_path) {
  if (mesh::is_mesh_name(name_or_path)) {
    return mesh_scene(name_or_path, {}, [](double) { return 1.0; });
  }
  if (is_scene_file(name_or_path)) {
    constexpr std::size_t largest = 1 << 20;
    const std::vector<std::uint8_t> bytes = system::read_file(name_or_path, largest);
    const std::string text(bytes.begin(), bytes.end());
    require_text(text, name_or_path);
    return parse_scene(text, name_or_path);
  }
  const std::string file = name_or_path + ".toml";
  const auto& builtin = embedded::scenes();
  if (!builtin.contains(file)) {
    throw unknown_name("scene", name_or_path, builtin_scene_names());
  }
  return parse(builtin.at(file), file, MeshFiles::built_in());
}

}  // namespace twrench::scene
