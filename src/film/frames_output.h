#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "system/error.h"
#include "video/earlier_run.h"
#include "video/frame_sequence.h"

namespace twrench::film {

/// What a run may do with existing frames.
enum class Reuse {
  none,       ///< Redraw frames of this video; do not touch others.
  resume,     ///< Keep intact frames of this video, and redraw those of meshes that have changed
              ///< since; do not touch others.
  overwrite,  ///< Redraw any frames.
};

/// The folder to which a run writes its frames, with what earlier runs left there.
class FramesOutput {
 public:
  /// Looks, and touches nothing. `film` is the manifest to be written, all but its frames, with the
  /// whole range that was asked for; `frames` are those that this run draws.
  /// Throws ForeignFramesError where the run would write over frames that it does not know to be of
  /// the same film.
  FramesOutput(std::filesystem::path folder, video::Manifest film, std::vector<int> frames,
               Reuse reuse);

  /// Returns how many of the frames have no file yet.
  std::size_t count_without_file() const;

  /// Locks the folder, looks again, because another run may have written there meanwhile, and
  /// begins to write. The manifest keeps its earlier records of the same video, so that a run
  /// killed at its start loses nothing; records of another video are dropped, as its frames are.
  /// Throws FileError, and ForeignFramesError as the constructor does.
  video::FrameSequence& open();

  /// With `resume`, returns the record of a frame that need not be drawn because it is intact, and
  /// keeps it.
  std::optional<video::FrameRecord> kept(const video::FrameRecord& wanted);

  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
  video::Manifest film_;
  std::vector<int> frames_;
  Reuse reuse_;
  video::EarlierRun earlier_;
  std::unique_ptr<video::FrameSequence> sequence_;  ///< Set by open().
};

}  // namespace twrench::film
