#include "video/shard.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include <charconv>
#include <cstdint>
#include <optional>

namespace twrench::video {
namespace {

constexpr int most_shards = 100'000;  // per video; each has a file

/// Parses "3/10", or with another separator.
std::optional<Shard> read_shard(std::string_view text, std::string_view separator) {
  Shard shard;
  const char* const end = text.data() + text.size();
  const auto index = std::from_chars(text.data(), end, shard.index);
  const std::string_view rest(index.ptr, end);
  if (index.ec != std::errc{} || !rest.starts_with(separator)) return std::nullopt;
  const auto count = std::from_chars(rest.data() + separator.size(), end, shard.count);
  const bool valid = count.ec == std::errc{} && count.ptr == end && shard.index >= 1 &&
                     shard.index <= shard.count && shard.count <= most_shards;
  return valid ? std::optional(shard) : std::nullopt;
}

}  // namespace

Shard parse_shard(std::string_view text) {
  if (const auto shard = read_shard(text, "/")) return *shard;
  throw InvalidArgument(fmt::format("shard '{}'", text), "it is not of the form i/n",
                        fmt::format("write i/n with 1 <= i <= n <= {}, such as 3/10", most_shards));
}

std::string format_shard(const Shard& shard) {
  return fmt::format("{}/{}", shard.index, shard.count);
}

std::vector<int> frames_of_shard(const std::vector<int>& frames, const Shard& shard) {
  const auto size = static_cast<std::int64_t>(frames.size());
  const auto end = [&](std::int64_t shards) {
    return frames.begin() + size * shards / shard.count;
  };
  return {end(shard.index - 1), end(shard.index)};
}

std::string manifest_file_name(const Shard& shard) {
  if (shard.is_whole()) return manifest_name;
  return fmt::format("manifest.{:04}-of-{:04}.json", shard.index, shard.count);
}

bool is_manifest_name(std::string_view name) {
  if (name == manifest_name) return true;
  constexpr std::string_view before = "manifest.";
  constexpr std::string_view after = ".json";
  if (!name.starts_with(before) || !name.ends_with(after)) return false;
  name.remove_prefix(before.size());
  if (name.size() < after.size()) return false;  // "manifest.json" with one dot for both
  name.remove_suffix(after.size());
  return read_shard(name, "-of-").has_value();
}

}  // namespace twrench::video
