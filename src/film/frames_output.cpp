#include "film/frames_output.h"

#include <algorithm>
#include <iterator>
#include <system_error>
#include <utility>

#include "film/error.h"
#include "video/frame_range.h"

namespace twrench::film {
namespace {

/// Throws if the run would destroy frames without permission.
void refuse_to_destroy(const std::filesystem::path& folder, const video::EarlierRun& earlier,
                       const video::Shard& shard, Reuse reuse) {
  if (earlier.objection().empty() || reuse == Reuse::overwrite) return;
  if (reuse == Reuse::resume && earlier.is_outdated()) return;
  throw ForeignFramesError(folder.string(), earlier.objection(), !shard.is_whole(),
                           earlier.is_unrecorded());
}

}  // namespace

FramesOutput::FramesOutput(std::filesystem::path folder, video::Manifest film,
                           std::vector<int> frames, Reuse reuse)
    : folder_(std::move(folder)),
      film_(std::move(film)),
      frames_(std::move(frames)),
      reuse_(reuse),
      earlier_(folder_, film_, frames_) {
  refuse_to_destroy(folder_, earlier_, film_.shard, reuse_);
}

std::size_t FramesOutput::count_without_file() const {
  return static_cast<std::size_t>(std::ranges::count_if(frames_, [&](int frame) {
    std::error_code failed;
    return !std::filesystem::exists(folder_ / video::frame_file_name(frame), failed);
  }));
}

video::FrameSequence& FramesOutput::open() {
  sequence_ = std::make_unique<video::FrameSequence>(folder_, film_);  // locks the folder
  // While this run waited for its lock, another run may have written frames and ended.
  earlier_ = video::EarlierRun(folder_, film_, frames_);
  refuse_to_destroy(folder_, earlier_, film_.shard, reuse_);
  const auto number = [](const video::FrameRecord& record) { return record.frame; };
  std::vector<int> told;
  std::ranges::transform(earlier_.own_records(), std::back_inserter(told), number);
  std::vector<int> range;
  std::ranges::set_union(video::parse_frame_range(film_.range, video::max_frame_count), told,
                         std::back_inserter(range));
  sequence_->set_range(video::format_frame_range(range));
  for (const auto& manifest : earlier_.foreign_manifests()) {
    std::error_code gone;  // another shard may have removed it first
    std::filesystem::remove(manifest, gone);
  }
  for (const video::FrameRecord& record : earlier_.own_records())
    sequence_->keep(record, record.sha256);
  return *sequence_;
}

std::optional<video::FrameRecord> FramesOutput::kept(const video::FrameRecord& wanted) {
  if (reuse_ != Reuse::resume) return std::nullopt;
  auto record = earlier_.intact(wanted);
  if (record) sequence_->keep(wanted, record->sha256);
  return record;
}

}  // namespace twrench::film
