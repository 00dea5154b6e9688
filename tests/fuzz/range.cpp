// Frame ranges, from the command line and from manifests, and shards.
#include <twrench/base/error.h>

#include <algorithm>
#include <string_view>

#include "target.h"
#include "video/frame_range.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace twrench;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  video::is_manifest_name(text);
  try {
    const video::Shard shard = video::parse_shard(text);
    require(video::parse_shard(video::format_shard(shard)) == shard, "a shard is read back");
    require(video::is_manifest_name(video::manifest_file_name(shard)),
            "its manifest is known by its name");
  } catch (const InvalidArgument&) {
  }
  constexpr int frame_count = 100'000;  // small, for many inputs per second
  try {
    const std::vector<int> frames = video::parse_frame_range(text, frame_count);
    require(!frames.empty(), "a range selects a frame");
    require(std::ranges::adjacent_find(frames, std::greater_equal{}) == frames.end(), "ascending");
    require(frames.front() >= 0 && frames.back() < frame_count, "within the film");
    require(video::parse_frame_range(video::format_frame_range(frames), frame_count) == frames,
            "read back");
  } catch (const InvalidArgument&) {
  }
  return 0;
}
