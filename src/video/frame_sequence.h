#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
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
