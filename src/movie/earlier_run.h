#pragma once

#include <filesystem>
#include <map>
#include <optional>

#include "movie/manifest.h"

namespace twrench {

/// Whether everything that determines the pixels of a frame is the same, its pose aside: program
/// version, scene, GL renderer and size.
bool same_film(const Manifest& a, const Manifest& b);

/// What a folder holds of earlier runs.
class EarlierRun {
 public:
  /// Looks at the folder, which need not exist. A manifest that cannot be read counts as none.
  explicit EarlierRun(std::filesystem::path folder);

  /// Frames or a manifest, of whatever film.
  bool exists() const { return exists_; }

  /// Null where there is none that can be read.
  const Manifest* manifest() const { return manifest_ ? &*manifest_ : nullptr; }

  /// The record of the frame on disk, if it shows `wanted`'s pose through the same camera, and the
  /// file is still what was written, to the last bit: that it exists proves nothing.
  std::optional<FrameRecord> intact(const FrameRecord& wanted) const;

 private:
  std::filesystem::path folder_;
  bool exists_ = false;
  std::optional<Manifest> manifest_;
  std::map<int, const FrameRecord*> by_number_;  ///< into manifest_
};

}  // namespace twrench
