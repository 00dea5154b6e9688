#include "video/frame_sequence.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "system/bytes.h"
#include "system/file.h"

namespace twrench::video {

namespace {

const std::filesystem::path& made(const std::filesystem::path& folder) {
  system::make_folder(folder);
  return folder;
}

}  // namespace

FrameSequence::FrameSequence(std::filesystem::path folder, Manifest manifest)
    : folder_(std::move(folder)),
      lock_(made(folder_),
            manifest.shard.is_whole() ? system::LockKind::exclusive : system::LockKind::shared),
      manifest_(std::move(manifest)) {
  if (manifest_.shard.is_whole()) return;
  shard_claim_.emplace(folder_ / manifest_file_name(manifest_.shard), system::Links::replace);
  shard_claim_->claim();
}

FrameSequence::~FrameSequence() {
  try {
    if (!finished_) {
      finish();
    }
  } catch (...) {  // NOLINT(bugprone-empty-catch): the failure that led here is the one to report
  }
}

void FrameSequence::write(const FrameRecord& record, std::span<const std::uint8_t> png) {
  {
    const auto hold = system::hold_termination();
    if (!begun_) write_manifest();
    begun_ = true;
  }
  system::PendingFile file(folder_ / frame_file_name(record.frame), system::Links::replace);
  file.write(png);
  const std::string digest = system::sha256_hex(png);
  const auto hold =
      system::hold_termination();  // a signal finds the frame either recorded or absent
  file.commit();
  tell(record, digest);
  if (Clock::now() >= next_manifest_) write_manifest();
}

void FrameSequence::keep(const FrameRecord& record, const std::string& sha256) {
  const auto hold = system::hold_termination();
  tell(record, sha256);
}

void FrameSequence::tell(const FrameRecord& record, const std::string& sha256) {
  Frame frame{&record, {}};
  sha256.copy(frame.sha256.data(), frame.sha256.size());
  const auto number = [](const Frame& other) { return other.record->frame; };
  const auto place = std::ranges::lower_bound(frames_, record.frame, {}, number);
  if (place != frames_.end() && number(*place) == record.frame) {
    *place = frame;
  } else {
    frames_.insert(place, frame);
  }
  finished_ = false;
}

std::size_t FrameSequence::count(std::span<const FrameRecord> records) const {
  const auto is_among = [&](const Frame& frame) {
    return std::less_equal<>()(records.data(), frame.record) &&
           std::less<>()(frame.record, records.data() + records.size());
  };
  return static_cast<std::size_t>(std::ranges::count_if(frames_, is_among));
}

void FrameSequence::finish() {
  const auto hold = system::hold_termination();
  write_manifest();
}

void FrameSequence::write_manifest() {
  const Clock::time_point start = Clock::now();
  system::PendingFile file(folder_ / manifest_file_name(manifest_.shard), system::Links::replace);
  twrench::video::write_manifest(
      manifest_, frames_.size(),
      [this](std::size_t i) {
        FrameRecord record = *frames_[i].record;
        record.file = frame_file_name(record.frame);
        record.sha256.assign(frames_[i].sha256.begin(), frames_[i].sha256.end());
        return record;
      },
      [&file](std::string_view text) {
        file.write(std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
      });
  file.commit();
  finished_ = true;
  // Every five seconds, but in a long video so rarely that it takes at most a twentieth of the
  // time.
  next_manifest_ = Clock::now() +
                   std::max<Clock::duration>(std::chrono::seconds(5), 20 * (Clock::now() - start));
}

}  // namespace twrench::video
