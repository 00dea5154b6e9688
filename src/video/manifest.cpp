#include "video/manifest.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "base/enumeration.h"

namespace twrench::video {
namespace {

using Json = nlohmann::ordered_json;

/// Titles and names may contain invalid UTF-8.
std::string json_text(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string format_head(const Manifest& manifest) {
  Json head{{"version", manifest.version},   {"scene", manifest.scene},
            {"renderer", manifest.renderer}, {"size", {manifest.width, manifest.height}},
            {"fps", manifest.fps},           {"encoder", manifest.encoder},
            {"range", manifest.range},       {"font", manifest.font}};
  const auto& [effort, crf] = manifest.quality;
  if (effort) head["encode"] = enumerator_name(*effort);
  if (crf) head["crf"] = *crf;
  if (!manifest.shard.is_whole()) head["shard"] = format_shard(manifest.shard);
  std::string text = "{\n";
  for (const auto& [key, value] : head.items()) {
    text += fmt::format("{}: {},\n", json_text(key), json_text(value));
  }
  text.pop_back();  // the line end, which is added again
  return text.append(frames_marker) + "\n";
}

std::string format_frame(const FrameRecord& record) {
  return Json{{"frame", record.frame},
              {"t", record.t},
              {"shot", record.shot},
              {"flips", record.flips},
              {"last_flip", record.flips > 0 ? Json(record.last_flip) : Json()},
              {"X", record.X},
              {"view", record.view},
              {"projection", record.projection},
              {"file", record.file},
              {"sha256", record.sha256}}
      .dump();
}

/// Returns whether two values of a scene are equal, ignoring the digests of meshes and, if a digest
/// differs, the density computed from a given mass.
bool equal_but_for_meshes(const nlohmann::ordered_json& a, const nlohmann::ordered_json& b) {
  if (!a.is_structured() || a.type() != b.type() || a.size() != b.size()) return a == b;
  if (a.is_array()) return std::ranges::equal(a, b, equal_but_for_meshes);
  const bool changed = a.contains("sha256") && b.contains("sha256") && a["sha256"] != b["sha256"];
  for (const auto& [key, value] : a.items()) {
    if (!b.contains(key)) return false;
    const bool follows = changed && (key == "sha256" || key == "density");
    if (!follows && !equal_but_for_meshes(value, b[key])) return false;
  }
  return true;
}

}  // namespace

bool is_in_frames_folder(const std::string& name) {
  return is_manifest_name(name) || (name.starts_with("frame_") && name.ends_with(".png"));
}

std::string frame_file_name(int frame) { return fmt::format("frame_{:06}.png", frame); }

void write_manifest(const Manifest& manifest, std::size_t count,
                    const std::function<FrameRecord(std::size_t)>& frame,
                    const std::function<void(std::string_view)>& write) {
  constexpr std::size_t piece = 1 << 16;
  std::string text = format_head(manifest);
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) text += ",\n";
    text += format_frame(frame(i));
    if (text.size() < piece) continue;
    write(text);
    text.clear();
  }
  write(text + "\n]\n}\n");
}

std::string format_manifest(const Manifest& manifest) {
  std::string text;
  write_manifest(
      manifest, manifest.frames.size(), [&](std::size_t i) { return manifest.frames[i]; },
      [&](std::string_view piece) { text += piece; });
  return text;
}

nlohmann::ordered_json without_sound(nlohmann::ordered_json scene) {
  if (!scene.is_object()) return scene;
  const auto film = scene.find("film");
  if (film != scene.end() && film->is_object()) {
    film->erase("audio");
    if (film->contains("sound")) (*film)["sound"] = "none";
  }
  const auto shots = scene.find("shot");
  if (shots != scene.end() && shots->is_array()) {
    for (Json& shot : *shots) {
      if (shot.is_object()) shot.erase("narration");
    }
  }
  return scene;
}

bool has_sound(const nlohmann::ordered_json& scene) { return without_sound(scene) != scene; }

bool same_film(const Manifest& a, const Manifest& b) {
  const auto same_scene = [&] {
    return a.scene == b.scene || without_sound(a.scene) == without_sound(b.scene);
  };
  return a.version == b.version && same_scene() && a.font == b.font && a.renderer == b.renderer &&
         a.width == b.width && a.height == b.height;
}

bool same_but_for_meshes(const Manifest& a, const Manifest& b) {
  if (!equal_but_for_meshes(without_sound(a.scene), without_sound(b.scene))) return false;
  Manifest other = b;
  other.scene = a.scene;
  return same_film(a, other);
}

}  // namespace twrench::video
