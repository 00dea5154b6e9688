#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "video/manifest.h"

namespace twrench::video {

/// The frames and manifests that earlier runs, and other runs in progress, left in a folder in
/// which a run will draw some frames of `film`.
class EarlierRun {
 public:
  /// Examines the folder, which need not exist. `film` is the manifest that the run will write,
  /// without frames. Of every other manifest only the head is read, unless it has frames that this
  /// run draws, so that a thousand shards in a folder do not each read all frames of the others.
  EarlierRun(std::filesystem::path folder, const Manifest& film, const std::vector<int>& frames);

  /// Returns why a run must not write here without permission: the folder has frames of another
  /// video, or frames that no manifest describes. Empty if there are none.
  const std::string& objection() const { return objection_; }

  /// Returns whether the objection is only that meshes have changed since this run's own frames
  /// were drawn.
  bool is_outdated() const { return outdated_; }

  /// Returns whether the objection is that no manifest describes the frames of the folder.
  bool is_unrecorded() const { return unrecorded_; }

  /// Returns the manifests that belong to other videos or cannot be read.
  const std::vector<std::filesystem::path>& foreign_manifests() const { return foreign_; }

  /// Returns the frames of the same video recorded so far in the manifest that this run will write.
  const std::vector<FrameRecord>& own_records() const { return own_; }

  /// Returns the record of the frame on disk if it shows `wanted`'s pose through the same camera
  /// and its file still has the recorded digest; existence alone proves nothing.
  std::optional<FrameRecord> intact(const FrameRecord& wanted) const;

 private:
  void add_objection(const std::filesystem::path& manifest, const std::string& why);
  void examine(const std::filesystem::path& manifest, const Manifest& film,
               const std::vector<int>& frames);
  /// Returns whether the run that wrote the manifest draws some of these frames.
  bool draws_any(const Manifest& head, const std::vector<int>& frames);

  std::filesystem::path folder_;
  std::string objection_;
  bool outdated_ = false, unrecorded_ = false;
  std::vector<std::filesystem::path> foreign_;
  std::vector<FrameRecord> own_;
  std::map<int, FrameRecord> by_number_;  ///< The records of this video.
  std::string last_range_;                ///< Range of a manifest; all shards have the same.
  std::vector<int> last_frames_;          ///< The frames selected by last_range_.
};

}  // namespace twrench::video
