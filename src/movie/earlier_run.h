#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "movie/manifest.h"

namespace twrench {

/// What a folder holds of earlier runs, and of others that write there now, for a run that is to
/// draw some frames of `film`.
class EarlierRun {
 public:
  /// Looks at the folder, which need not exist. `film` is the manifest that the run will write, all
  /// but its frames. Of each other manifest only the head is read, unless it has frames that this
  /// run draws: so a thousand shards in a folder do not each read what all have written.
  EarlierRun(std::filesystem::path folder, const Manifest& film, const std::vector<int>& frames);

  /// Why a run must not write here unasked: there are frames of another film, or of none that a
  /// manifest tells of. Empty where all is of this film, or there is nothing.
  const std::string& objection() const { return objection_; }

  /// The manifests that are not of this film, or that cannot be read.
  const std::vector<std::filesystem::path>& foreign_manifests() const { return foreign_; }

  /// What the manifest that this run will write told so far, of the same film.
  const std::vector<FrameRecord>& own_records() const { return own_; }

  /// The record of the frame on disk, if it shows `wanted`'s pose through the same camera, and the
  /// file is still what was written, to the last bit: that it exists proves nothing.
  std::optional<FrameRecord> intact(const FrameRecord& wanted) const;

 private:
  void object_to(const std::filesystem::path& manifest, const std::string& why);
  void look_at(const std::filesystem::path& manifest, const Manifest& film,
               const std::vector<int>& frames);
  /// Whether the run that the manifest is of draws some of these frames.
  bool draws_any(const Manifest& head, const std::vector<int>& frames);

  std::filesystem::path folder_;
  std::string objection_;
  std::vector<std::filesystem::path> foreign_;
  std::vector<FrameRecord> own_;
  std::map<int, FrameRecord> by_number_;  ///< of this film
  std::string last_range_;                ///< of a manifest: all shards have the same
  std::vector<int> last_frames_;          ///< what it selects
};

}  // namespace twrench
