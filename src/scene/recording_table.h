#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "scene/mesh_files.h"
#include "scene/recording_file.h"
#include "scene/scene.h"
#include "scene/toml_table.h"

// The recording_keys() of [motion], which name a recorded motion.

namespace twrench::scene {

/// Returns the name of a key in messages.
using NameOfKey = std::function<std::string(const std::string& key)>;

/// Returns the convention that the keys state. Throws InvalidArgument.
recording::Convention convention_of(const nlohmann::ordered_json& keys, const NameOfKey& name_of);

/// Returns the recording that the keys name. Throws InvalidArgument.
RecordingFile recording_file(const nlohmann::ordered_json& keys, const std::filesystem::path& path,
                             const NameOfKey& name_of);

/// Reads the keys without opening the file of the recording. Returns null if there are none. Throws
/// InvalidArgument.
std::shared_ptr<const RecordingFile> read_recording_file(TomlTable& motion, const MeshFiles& files);

/// Calls `show`, which reads the recording that a scene names. Its errors propose the keys of the
/// scene for what they mention as arguments, such as the columns.
void propose_keys(const std::function<void()>& show);

/// Throws InvalidArgument if the scene file names a recorded motion. `what` names a result that is
/// computed, such as "a study".
void require_computed(const Scene& scene, const std::string& what);

}  // namespace twrench::scene
