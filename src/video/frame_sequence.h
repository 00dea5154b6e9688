#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "system/error.h"
#include "system/file_lock.h"
#include "system/pending_file.h"
#include "video/manifest.h"

namespace twrench::video {

/// Writes the frames of a video into a folder, and the manifest that describes them. Its state is
/// guarded by hold_termination(), so that the TerminationAction of a run can call finish().
class FrameSequence {
 public:
  /// Creates the folder if it is missing. Locks it for this run or, if the run draws a shard, for
  /// all shards. `manifest` has no frames. Throws FileError, also if another run writes to the
  /// folder or draws the same shard.
  FrameSequence(std::filesystem::path folder, Manifest manifest);

  /// Sets the range of the manifest. Call it before the first frame.
  void set_range(std::string range) { manifest_.range = std::move(range); }

  /// Writes the manifest unless finish() has, so that the frames of a failed run are recorded too.
  /// Errors are ignored: they would hide the original one.
  ~FrameSequence();
  FrameSequence(const FrameSequence&) = delete;
  FrameSequence& operator=(const FrameSequence&) = delete;

  /// Writes a frame's PNG and records it. `record` must outlive the sequence; its file and sha256
  /// may be empty. Frames may arrive in any order and from several threads. Throws FileError.
  void write(const FrameRecord& record, std::span<const std::uint8_t> png);
  void write(const FrameRecord&& record, std::span<const std::uint8_t> png) = delete;

  /// Records a frame that already exists in the folder as `record`, which must outlive the
  /// sequence; `sha256` is the digest of its file.
  void keep(const FrameRecord& record, const std::string& sha256);

  /// Writes the manifest of the frames so far, in ascending order. Throws FileError.
  void finish();

  /// Returns how many of these records the manifest contains; excludes frames of earlier runs.
  std::size_t count(std::span<const FrameRecord> records) const;

 private:
  using Clock = std::chrono::steady_clock;

  /// A frame in the folder. Compact, so that ten thousand of them are not kept in memory twice.
  struct Frame {
    const FrameRecord* record;
    std::array<char, 64> sha256;
  };

  void tell(const FrameRecord& record, const std::string& sha256);
  void write_manifest();

  const std::filesystem::path folder_;
  const system::FolderLock lock_;
  /// Locks this run's shard; empty for a whole video. It is never committed.
  std::optional<system::PendingFile> shard_claim_;
  Manifest manifest_;
  /// Ascending by number.
  std::vector<Frame> frames_;
  Clock::time_point next_manifest_ = Clock::now();
  /// Whether a manifest was written; this happens before any frame, so that every frame has one.
  bool begun_ = false;
  /// Whether the manifest on disk describes all frames.
  bool finished_ = true;
};

}  // namespace twrench::video
