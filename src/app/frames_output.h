#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "movie/earlier_run.h"
#include "movie/frame_sequence.h"

namespace twrench {

/// What a run may do with the frames that it finds.
enum class Reuse {
  none,       ///< draw over those of this film, refuse to touch others
  resume,     ///< keep those of this film that are whole, refuse to touch others
  overwrite,  ///< draw over any
};

/// The folder that a run writes its frames to, with what earlier runs left there.
class FramesOutput {
 public:
  /// Looks, and touches nothing. `film` is the manifest to be written, all but its frames, with the
  /// whole range that was asked for; `frames` are those that this run draws.
  /// Throws OverwriteError where the run would write over frames that it does not know to be of the
  /// same film.
  FramesOutput(std::filesystem::path folder, Manifest film, std::vector<int> frames, Reuse reuse);

  /// How many of the frames have no file yet.
  std::size_t count_without_file() const;

  /// Begins to write. The manifest goes on with what it told of the same film, so that a run which
  /// is killed at its start loses nothing; those of another film go, for so do its frames.
  /// Throws FileError.
  FrameSequence& open();

  /// With `resume`, the record of the frame where it need not be drawn: it is whole, and kept.
  std::optional<FrameRecord> kept(const FrameRecord& wanted);

  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
  Manifest film_;
  std::vector<int> frames_;
  Reuse reuse_;
  EarlierRun earlier_;
  std::unique_ptr<FrameSequence> sequence_;  ///< once open
};

}  // namespace twrench
