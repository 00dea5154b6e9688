#include "video/manifest_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <system_error>

#include "system/file.h"
#include "video/error.h"
#include "video/frame_range.h"

namespace twrench::video {
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
