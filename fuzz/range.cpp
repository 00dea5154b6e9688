// Frame ranges, from the command line and from manifests, and shards.
#include <algorithm>
#include <string_view>

#include "base/error.h"
#include "movie/frame_range.h"
#include "movie/shard.h"
#include "target.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace twrench;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  is_manifest_name(text);
  try {
    const Shard shard = parse_shard(text);
    require(parse_shard(format_shard(shard)) == shard, "a shard is read back");
    require(is_manifest_name(manifest_file_name(shard)), "its manifest is known by its name");
  } catch (const UsageError&) {
  }
  constexpr int frame_count = 100'000;  // small, for many inputs per second
  try {
    const std::vector<int> frames = parse_frame_range(text, frame_count);
    require(!frames.empty(), "a range selects a frame");
    require(std::ranges::adjacent_find(frames, std::greater_equal{}) == frames.end(), "ascending");
    require(frames.front() >= 0 && frames.back() < frame_count, "within the film");
    require(parse_frame_range(format_frame_range(frames), frame_count) == frames, "read back");
  } catch (const UsageError&) {
  }
  return 0;
}
