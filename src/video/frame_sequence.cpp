#include "video/frame_sequence.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <system_error>

#include "system/bytes.h"
#include "system/file.h"
#include "video/frame_range.h"

namespace twrench::video {
namespace {

bool has_frames(const std::filesystem::path& folder) {
  std::error_code failed;
  const std::filesystem::directory_iterator entries(folder, failed);
  return !failed && std::ranges::any_of(entries, [](const auto& entry) {
    return entry.path().filename().string().starts_with("frame_");
  });
}

}  // namespace

EarlierRun::EarlierRun(std::filesystem::path folder, const Manifest& film,
                       const std::vector<int>& frames)
    : folder_(std::move(folder)) {
  // In this order, because a run that starts at this moment writes its manifest before any frame.
  const bool has_any_frames = has_frames(folder_);
  const std::vector<std::filesystem::path> manifests = manifests_in(folder_);
  for (const auto& manifest : manifests) examine(manifest, film, frames);
  if (objection_.empty() && has_any_frames && manifests.empty()) {
    objection_ = "contains frames without a manifest";
    unrecorded_ = true;
  }
}

void EarlierRun::add_objection(const std::filesystem::path& manifest, const std::string& why) {
  foreign_.push_back(manifest);
  outdated_ = false;
  if (objection_.empty()) {
    objection_ = fmt::format("contains {} ({})", why, manifest.filename().string());
  }
}

bool EarlierRun::draws_any(const Manifest& head, const std::vector<int>& frames) {
  if (head.range != last_range_) {
    last_range_ = head.range;
    last_frames_ = parse_frame_range(head.range, max_frame_count);
  }
  return std::ranges::any_of(frames_of_shard(last_frames_, head.shard),
                             [&](int frame) { return std::ranges::binary_search(frames, frame); });
}

void EarlierRun::examine(const std::filesystem::path& manifest, const Manifest& film,
                         const std::vector<int>& frames) {
  try {
    const Manifest head = read_manifest_head(manifest);
    if (!same_film(head, film)) {
      const bool first = objection_.empty();
      add_objection(manifest, "frames of another scene, mesh, font, size, renderer or version");
      outdated_ = first && head.shard == film.shard && same_but_for_meshes(head, film);
      return;
    }
    const bool is_own = head.shard == film.shard;
    if (!is_own && !draws_any(head, frames)) return;
    std::vector<FrameRecord> records = read_manifest(manifest).frames;
    for (const FrameRecord& record : records) by_number_.insert_or_assign(record.frame, record);
    if (is_own) own_ = std::move(records);
  } catch (const system::FileError&) {
    add_objection(manifest, "a manifest that is damaged or was not written by this program");
  }
}

std::optional<FrameRecord> EarlierRun::intact(const FrameRecord& wanted) const {
  const auto found = by_number_.find(wanted.frame);
  if (found == by_number_.end()) return std::nullopt;
  const FrameRecord& record = found->second;
  if (record.t != wanted.t || record.X != wanted.X || record.view != wanted.view ||
      record.projection != wanted.projection) {
    return std::nullopt;
  }
  try {
    constexpr std::size_t longest = 1U << 30U;
    if (system::sha256_hex(system::read_regular_file(folder_ / record.file, longest)) !=
        record.sha256)
      return std::nullopt;
  } catch (const system::FileError&) {
    return std::nullopt;
  }
  return record;
}

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
