#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace twrench::video {

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
