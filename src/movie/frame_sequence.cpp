#include "movie/frame_sequence.h"

#include <algorithm>
#include <utility>

#include "base/file.h"
#include "base/sha256.h"

namespace twrench {

FrameSequence::FrameSequence(std::filesystem::path folder, Manifest manifest)
    : folder_(std::move(folder)), manifest_(std::move(manifest)) {
  make_folder(folder_);
}

FrameSequence::~FrameSequence() {
  try {
    if (!finished_) {
      finish();
    }
  } catch (...) {  // NOLINT(bugprone-empty-catch): the failure that led here is the one to report
  }
}

void FrameSequence::write(FrameRecord record, std::span<const std::uint8_t> png) {
  record.file = frame_file_name(record.frame);
  record.sha256 = sha256_hex(png);
  {
    const std::lock_guard lock(mutex_);
    if (!begun_) write_manifest();
    begun_ = true;
  }
  write_file_atomically(folder_ / record.file, png);
  const std::lock_guard lock(mutex_);
  const int frame = record.frame;
  records_.insert_or_assign(frame, std::move(record));
  finished_ = false;
  if (Clock::now() >= next_manifest_) write_manifest();
}

void FrameSequence::keep(const FrameRecord& record) {
  const std::lock_guard lock(mutex_);
  records_.insert_or_assign(record.frame, record);
  finished_ = false;
}

void FrameSequence::finish() {
  const std::lock_guard lock(mutex_);
  write_manifest();
}

void FrameSequence::write_manifest() {
  const Clock::time_point start = Clock::now();
  manifest_.frames.clear();
  for (const auto& [frame, record] : records_) {
    manifest_.frames.push_back(record);
  }
  write_file_atomically(folder_ / manifest_file_name(manifest_.shard), format_manifest(manifest_));
  finished_ = true;
  // Every five seconds, but of a long film never more than a twentieth of the time.
  next_manifest_ = Clock::now() +
                   std::max<Clock::duration>(std::chrono::seconds(5), 20 * (Clock::now() - start));
}

}  // namespace twrench
