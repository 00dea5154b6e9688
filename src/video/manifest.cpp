#include "video/manifest.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <system_error>

#include "base/enumeration.h"
#include "system/file.h"
#include "video/error.h"
#include "video/frame_range.h"

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

namespace {

namespace fs = std::filesystem;

FramesError disagreement(const fs::path& a, const fs::path& b, const std::string& on) {
  return {fmt::format("cannot use {} with {}", b.string(), a.filename().string()), on,
          FramesError::Reason::contradictory};
}

/// How the two videos differ, for an error message.
std::string difference(const Manifest& a, const Manifest& b) {
  if (a.version != b.version) return fmt::format("versions {} and {}", a.version, b.version);
  if (a.renderer != b.renderer) return fmt::format("renderers {} and {}", a.renderer, b.renderer);
  if (a.font != b.font) return "another font file";
  return a.scene != b.scene ? "another scene" : "another size";
}

/// Merges the manifests of a folder.
class Union {
 public:
  explicit Union(const fs::path& first) : first_(first), all_(read_manifest(first)) {
    asked_ = parse_frame_range(all_.range, max_frame_count);
    for (const FrameRecord& record : all_.frames) frames_.emplace(record.frame, Found{record, 0});
    paths_.push_back(first);
  }

  void add(const fs::path& path) {
    const Manifest more = read_manifest(path);
    if (!same_film(all_, more)) throw disagreement(first_, path, difference(all_, more));
    if (more.range != last_range_) {
      std::vector<int> both;
      std::ranges::set_union(asked_, parse_frame_range(more.range, max_frame_count),
                             std::back_inserter(both));
      asked_ = std::move(both);
      last_range_ = more.range;
    }
    for (const FrameRecord& record : more.frames) {
      const auto [there, is_new] = frames_.emplace(record.frame, Found{record, paths_.size()});
      if (is_new || there->second.record.sha256 == record.sha256) continue;
      throw disagreement(paths_[there->second.path], path,
                         fmt::format("they record different digests for frame {}", record.frame));
    }
    paths_.push_back(path);
  }

  Manifest manifest() && {
    all_.range = format_frame_range(asked_);
    all_.shard = {};
    all_.frames.clear();
    for (auto& [frame, found] : frames_) all_.frames.push_back(std::move(found.record));
    return std::move(all_);
  }

 private:
  struct Found {
    FrameRecord record;
    std::size_t path;  ///< in paths_
  };

  fs::path first_;
  Manifest all_;
  std::string last_range_ = all_.range;
  std::vector<int> asked_;
  std::map<int, Found> frames_;
  std::vector<fs::path> paths_;
};

}  // namespace

std::vector<fs::path> manifests_in(const fs::path& folder) {
  std::vector<fs::path> paths;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(folder, failed)) {
    if (is_manifest_name(entry.path().filename().string())) paths.push_back(entry.path());
  }
  if (failed && failed != std::errc::no_such_file_or_directory &&
      failed != std::errc::not_a_directory) {
    throw system::file_error("cannot read the folder " + folder.string(), failed.value(),
                             system::Access::read);
  }
  std::ranges::sort(paths);
  return paths;
}

Manifest read_manifests(const fs::path& folder) {
  const std::vector<fs::path> paths = manifests_in(folder);
  if (paths.empty()) {
    throw FramesError("cannot use " + folder.string(),
                      fs::exists(folder) ? "it contains neither manifest.json nor shard manifests"
                                         : "there is no such folder",
                      FramesError::Reason::no_manifest);
  }
  if (paths.size() == 1) return read_manifest(paths.front());
  Union all(paths.front());
  std::for_each(paths.begin() + 1, paths.end(), [&](const fs::path& path) { all.add(path); });
  return std::move(all).manifest();
}

}  // namespace twrench::video
