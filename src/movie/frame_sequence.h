#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/folder_lock.h"
#include "base/pending_file.h"
#include "movie/manifest.h"

namespace twrench {

/// Writes the frames of a film into a folder, and the manifest that tells what is there. Threads
/// take turns at what it knows by hold_termination(): so the TerminationAction of a run can call
/// finish().
class FrameSequence {
 public:
  /// Makes the folder where it is missing, and locks it: for this run, or, as a shard of a film,
  /// for runs of its other shards too. `manifest` is all but its frames. Throws FileError, also
  /// where another run writes to the folder, or the same shard.
  FrameSequence(std::filesystem::path folder, Manifest manifest);

  /// Writes the manifest where finish() has not: what a run that fails leaves is told, too. A
  /// failure to do so is not: it would hide the first.
  ~FrameSequence();
  FrameSequence(const FrameSequence&) = delete;
  FrameSequence& operator=(const FrameSequence&) = delete;

  /// Writes a frame's PNG and tells of it; `record`, which outlives the sequence, needs no file and
  /// no sha256. Frames may come in any order and from several threads at once. Throws FileError.
  void write(const FrameRecord& record, std::span<const std::uint8_t> png);
  void write(const FrameRecord&& record, std::span<const std::uint8_t> png) = delete;

  /// Takes a frame that stands in the folder already into the manifest, as `record`, which outlives
  /// the sequence, tells of it; `sha256` is its file's.
  void keep(const FrameRecord& record, const std::string& sha256);

  /// Writes the manifest of the frames so far, ascending. Throws FileError.
  void finish();

  /// How many of these very records the manifest tells of: of a run, without those before it.
  std::size_t count(std::span<const FrameRecord> records) const;

 private:
  using Clock = std::chrono::steady_clock;

  /// A frame that stands in the folder. Ten thousand of them are not to be held twice.
  struct Frame {
    const FrameRecord* record;
    std::array<char, 64> sha256;
  };

  void tell(const FrameRecord& record, const std::string& sha256);
  void write_manifest();

  const std::filesystem::path folder_;
  const FolderLock lock_;
  std::optional<PendingFile> shard_claim_;  ///< none for a whole film; never becomes the manifest
  Manifest manifest_;
  std::vector<Frame> frames_;  ///< ascending by number
  Clock::time_point next_manifest_ = Clock::now();
  bool begun_ = false;    ///< a manifest was written; before any frame, so that none is nobody's
  bool finished_ = true;  ///< the manifest on disk tells of all frames
};

}  // namespace twrench
