#include "scene/recording_table.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>

#include "base/words.h"
#include "recording/columns/columns.h"
#include "scene/fields.h"
#include "scene/keys.h"
#include "scene/limits.h"

namespace twrench::scene {
namespace {

using nlohmann::ordered_json;

/// Returns what is wrong with the quantity of an error.
std::string why_of(const InvalidArgument& error) {
  return std::string(error.what()).substr(error.quantity().size() + 2);
}

void set_field(const recording::Field& field, recording::Convention& convention,
               const ordered_json& value, const std::string& what) {
  switch (field.form) {
    case recording::FieldForm::flag:
      return field.set(convention, value.get<bool>());
    case recording::FieldForm::rotation:
      return field.set(convention, limits::check_rotation(what, to_quaternion(value)));
    case recording::FieldForm::text:
      return field.set(convention, value.get<std::string>());
    case recording::FieldForm::unasked:
      return;
  }
}

double time_in(const ordered_json& keys, const std::string& key, double otherwise,
               const NameOfKey& name_of) {
  if (!keys.contains(key)) return otherwise;
  return limits::check(limits::coordinate, name_of(key), keys.at(key).get<double>());
}

/// Returns a value as a string of TOML.
std::string in_toml(std::string_view value) { return ordered_json(value).dump(); }

/// Returns how a scene file gives an argument. Arguments that are no keys remain mentions.
std::string as_key(std::string_view name, std::string_view value) {
  const std::vector<Key>& keys = recording_keys();
  const auto key = std::ranges::find(keys, name, &Key::name);
  if (key == keys.end()) return argument(name, value);
  if (key->form.kind == ValueForm::Kind::flag) return fmt::format("{} = true", name);
  if (value.empty()) return fmt::format("the key {}", name);
  if (key->form.kind == ValueForm::Kind::text) return fmt::format("{} = {}", name, in_toml(value));
  return fmt::format("{} = [{}]", name, value);
}

constexpr const char* in_scene = " in [motion] of the scene";

std::string remedy_by_keys(const Error& error) {
  const std::string remedy = with_arguments(error.remedy(), as_key);
  return remedy == error.remedy() ? remedy : remedy + "," + in_scene;
}

std::string remedy_by_keys(const recording::ColumnError& error) {
  if (!error.suggested().empty()) {
    return "if they are meant, add " + as_key("columns", error.suggested()) + in_scene;
  }
  const std::string& ours = error.column();
  const std::string all = "t=NAME,wx=NAME,wy=NAME,wz=NAME";
  return fmt::format("{}{} names {}; {}", as_key("columns", ours.empty() ? all : ours + "=NAME"),
                     in_scene, ours.empty() ? "them" : "it", error.remedy());
}

}  // namespace

recording::Convention convention_of(const ordered_json& keys, const NameOfKey& name_of) {
  recording::Convention convention;
  for (const recording::Field& field : recording::convention_fields()) {
    const auto found = keys.find(field.name);
    if (found == keys.end()) continue;
    try {
      set_field(field, convention, *found, name_of(field.name));
    } catch (const InvalidArgument& error) {
      throw InvalidArgument(name_of(field.name), why_of(error), error.remedy());
    }
  }
  return convention;
}

RecordingFile recording_file(const ordered_json& keys, const std::filesystem::path& path,
                             const NameOfKey& name_of) {
  RecordingFile file{.file = keys.at(recording_file_key).get<std::string>(), .path = path};
  file.from = time_in(keys, "from", file.from, name_of);
  file.to = time_in(keys, "to", file.to, name_of);
  file.smooth = keys.value("smooth", false);
  file.convention = convention_of(keys, name_of);
  file.keys = keys.dump(-1, ' ', true, ordered_json::error_handler_t::replace);
  return file;
}

std::shared_ptr<const RecordingFile> read_recording_file(TomlTable& motion,
                                                         const MeshFiles& files) {
  ordered_json keys = ordered_json::object();
  for (const Key& key : recording_keys()) {
    if (auto value = motion.value(key.name, key.form.kind)) keys[key.name] = std::move(*value);
  }
  if (keys.empty()) return nullptr;
  if (!keys.contains(recording_file_key)) {
    throw InvalidArgument(motion.place(keys.begin().key()),
                          "it applies to a recorded motion, and there is none",
                          "name the recording by the key file, or leave the key out");
  }
  const auto file = keys.at(recording_file_key).get<std::string>();
  if (file.empty()) {
    throw InvalidArgument(motion.place(recording_file_key), "is empty",
                          "name the file of a recording");
  }
  for (const char* key : keys_of_computed_motions) {
    if (!motion.has(key)) continue;
    throw InvalidArgument(motion.place(key), "the motion is recorded in " + file,
                          "leave out this key or the key file");
  }
  return std::make_shared<const RecordingFile>(recording_file(
      keys, files.path_of(file), [&](const std::string& key) { return motion.place(key); }));
}

void propose_keys(const std::function<void()>& show) try {
  show();
} catch (const recording::ColumnError& error) {
  throw InvalidArgument(error.quantity(), with_arguments(why_of(error), as_key),
                        remedy_by_keys(error));
} catch (const InvalidArgument& error) {
  const std::string remedy = remedy_by_keys(error);
  if (remedy == error.remedy()) throw;
  throw InvalidArgument(error.quantity(), with_arguments(why_of(error), as_key), remedy);
}

void require_computed(const Scene& scene, const std::string& what) {
  if (!scene.motion.recording_file) return;
  throw InvalidArgument(scene.name,
                        "the motion is recorded in " + scene.motion.recording_file->file +
                            ", and " + what + " is of a computed motion",
                        "use a scene whose [motion] has omega instead of file");
}

}  // namespace twrench::scene
