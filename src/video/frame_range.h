#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace twrench::video {

/// The maximum number of frames of a video, two days at 60 per second. Limits the memory that input
/// can request.
constexpr int max_frame_count = 10'000'000;

/// Returns the frames that a RANGE selects, ascending and without repetition. RANGE is `a`, `a-b`
/// (both included) or `a-b:step`, several separated by commas; frame numbers are less than
/// frame_count. Throws InvalidArgument with the invalid part and the allowed values.
std::vector<int> parse_frame_range(std::string_view range, int frame_count);

/// Throws as parse_frame_range() does, without listing the frames.
void check_frame_range(std::string_view range, int frame_count);

/// Returns the RANGE of exactly these ascending frames, for example "0-3,7".
std::string format_frame_range(std::span<const int> frames);

/// The same for messages: if there are many runs, the first ones and the total number of frames.
std::string brief_frame_range(std::span<const int> frames);

/// One of the parts into which several runs divide the same frames.
struct Shard {
  /// Number of the part, from 1 to count.
  int index = 1;
  /// Number of parts.
  int count = 1;

  bool is_whole() const { return count == 1; }
  bool operator==(const Shard&) const = default;
};

/// Parses a shard such as "3/10". Throws InvalidArgument if it is invalid.
Shard parse_shard(std::string_view text);

std::string format_shard(const Shard& shard);

/// Returns the frames of the shard, which are consecutive. The sizes of shards differ by at most
/// one. A short RANGE thus describes the frames that a lost shard leaves missing, and the encoder
/// reads the files in the order in which a machine wrote them. Interleaving would not balance the
/// load better, because all frames of a video cost nearly the same. Some shards are empty if there
/// are fewer frames than shards.
std::vector<int> frames_of_shard(const std::vector<int>& frames, const Shard& shard);

/// The file name of the manifest of a run that draws all frames.
constexpr const char* manifest_name = "manifest.json";

/// Returns that name, or for a shard a name such as "manifest.0003-of-0010.json".
std::string manifest_file_name(const Shard& shard);

/// Returns whether a file of this name is a manifest of a whole video or of a shard.
bool is_manifest_name(std::string_view name);

}  // namespace twrench::video
