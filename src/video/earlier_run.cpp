#include "video/earlier_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "system/bytes.h"
#include "system/error.h"
#include "system/file.h"
#include "video/frame_range.h"
#include "video/manifest.h"

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

}  // namespace twrench::video
