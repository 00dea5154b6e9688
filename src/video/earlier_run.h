#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "video/manifest.h"

namespace twrench::video {

/// What earlier runs, and other runs in progress, left in a folder, for a run that will draw some
/// frames of `film`.
class EarlierRun {
 public:
  /// Examines the folder, which need not exist. `film` is the manifest that the run will write,
  /// without frames. Only the head of every other manifest is read, unless it has frames that this
  /// run draws, so that a thousand shards in a folder do not each read all frames of the others.
  EarlierRun(std::filesystem::path folder, const Manifest& film, const std::vector<int>& frames);

  /// Returns why a run must not write here without permission: the folder has frames of another
  /// video, or frames that no manifest describes. Empty if there are none.
  const std::string& objection() const { return objection_; }

  /// Returns whether the objection is only that meshes have changed since this run's own frames
  /// were drawn.
  bool is_outdated() const { return outdated_; }

  /// Returns the manifests that belong to other videos or cannot be read.
  const std::vector<std::filesystem::path>& foreign_manifests() const { return foreign_; }

  /// Returns the frames recorded so far in the manifest that this run will write, of the same
  /// video.
  const std::vector<FrameRecord>& own_records() const { return own_; }

  /// Returns the record of the frame on disk if it shows `wanted`'s pose through the same camera
  /// and its file still has the recorded digest; existence alone proves nothing.
  std::optional<FrameRecord> intact(const FrameRecord& wanted) const;

 private:
  void object_to(const std::filesystem::path& manifest, const std::string& why);
  void look_at(const std::filesystem::path& manifest, const Manifest& film,
               const std::vector<int>& frames);
  /// Returns whether the run that wrote the manifest draws some of these frames.
  bool draws_any(const Manifest& head, const std::vector<int>& frames);

  std::filesystem::path folder_;
  std::string objection_;
  bool outdated_ = false;
  std::vector<std::filesystem::path> foreign_;
  std::vector<FrameRecord> own_;
  std::map<int, FrameRecord> by_number_;  ///< Of this video.
  std::string last_range_;                ///< Range of a manifest; all shards have the same.
  std::vector<int> last_frames_;          ///< The frames that it selects.
};

}  // namespace twrench::video
