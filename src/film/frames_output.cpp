#include "film/frames_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <system_error>
#include <utility>

#include "film/error.h"
#include "image/png.h"
#include "system/file.h"
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

namespace {

/// Bytes, in floating point because the largest possible requests exceed integers.
struct Need {
  double frames = 0;
  double film = 0;
};

struct Shortage {
  std::filesystem::path path;
  double free;
  double needed;
};

/// Returns the first location with too little room, if any.
std::optional<Shortage> find_shortage(const PlannedOutput& output, const Need& need) {
  const bool shared = output.frames_folder && output.film &&
                      system::on_same_disk(*output.frames_folder, output.film->parent_path());
  if (output.frames_folder) {
    const auto free = static_cast<double>(system::free_space(*output.frames_folder));
    const double needed = need.frames + (shared ? need.film : 0);
    if (needed > free) return Shortage{*output.frames_folder, free, needed};
  }
  if (output.film) {
    const auto free = static_cast<double>(system::free_space(output.film->parent_path()));
    if (need.film > free) return Shortage{*output.film, free, need.film};
  }
  return std::nullopt;
}

}  // namespace

void require_space(const PlannedOutput& output, const std::function<image::Image()>& draw_one) {
  const auto new_frames = static_cast<double>(output.new_frames);
  const auto film_frames = static_cast<double>(output.film_frames);
  constexpr double png_bytes_a_pixel = 4.1;  // uncompressed RGBA with filter and block headers
  constexpr double film_bytes_a_pixel = 0.25;
  const Need bound{new_frames * output.frame_pixels * png_bytes_a_pixel,
                   film_frames * output.frame_pixels * film_bytes_a_pixel};
  if (!find_shortage(output, bound)) return;
  const auto png = static_cast<double>(image::encode_png(draw_one()).size());
  const Need estimate{1.25 * png * new_frames, 0.1 * png * film_frames};
  if (const auto shortage = find_shortage(output, estimate)) {
    throw SpaceError(
        "cannot write " + shortage->path.string(),
        fmt::format("{} are free, but the run needs an estimated {}",
                    system::format_bytes(shortage->free), system::format_bytes(shortage->needed)));
  }
}

}  // namespace twrench::film
