#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace twrench {

/// Part `index` of the `count` that several runs draw of the same frames; index is from 1.
struct Shard {
  int index = 1;
  int count = 1;

  bool is_whole() const { return count == 1; }
  bool operator==(const Shard&) const = default;
};

/// "3/10". Throws UsageError for what is none.
Shard parse_shard(std::string_view text);
std::string format_shard(const Shard& shard);

/// The frames that are the shard's: a run of neighbours, the shards alike in length but for one
/// frame. Neighbours, because then a RANGE names what a lost shard leaves missing in a few letters,
/// and the encoder reads the files in the order in which one machine wrote them; frames of one film
/// cost nearly the same, so that an interleave would balance nothing. Some shards are empty where
/// there are fewer frames than shards.
std::vector<int> frames_of_shard(const std::vector<int>& frames, const Shard& shard);

/// The name of the manifest of a run that draws all, in its folder of frames.
constexpr const char* manifest_name = "manifest.json";

/// That name, or of a shard's manifest "manifest.0003-of-0010.json".
std::string manifest_file_name(const Shard& shard);

/// Whether a file of this name is a manifest, the whole's or a shard's.
bool is_manifest_name(std::string_view name);

}  // namespace twrench
