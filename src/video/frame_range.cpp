#include "video/frame_range.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace twrench::video {
namespace {

/// Bounds the work for a range that selects the same frames repeatedly.
constexpr std::int64_t most_named = std::int64_t{10} * max_frame_count;

/// One part of a RANGE: first, first + step, ... up to last.
struct Run {
  int first;
  int last;
  int step;
};

/// Parses the entire text as a number; nothing if it is not a number or is too large.
std::optional<int> number(std::string_view digits) {
  int value = 0;
  const char* end = digits.data() + digits.size();
  const auto [rest, failed] = std::from_chars(digits.data(), end, value);
  if (failed != std::errc{} || rest != end) {
    return std::nullopt;
  }
  return value;
}

/// Removes the part before the first `separator`, and the separator, from `text`, and returns that
/// part; the whole text if it has no separator.
std::string_view take_until(std::string_view& text, char separator) {
  const std::size_t at = text.find(separator);
  const std::string_view head = text.substr(0, at);
  text.remove_prefix(at == std::string_view::npos ? text.size() : at + 1);
  return head;
}

std::optional<Run> parse_run(std::string_view text) {
  const bool has_step = text.find(':') != std::string_view::npos;
  std::string_view frames = take_until(text, ':');
  const auto step = has_step ? number(text) : 1;
  const bool has_last = frames.find('-') != std::string_view::npos;
  const auto first = number(take_until(frames, '-'));
  const auto last = has_last ? number(frames) : first;
  if (!first || !last || !step || *step < 1 || *first > *last || (has_step && !has_last)) {
    return std::nullopt;
  }
  return Run{*first, *last, *step};
}

std::vector<Run> parse_runs(std::string_view range, int frame_count) {
  const std::string what = fmt::format("frames '{}'", range);
  std::vector<Run> runs;
  std::int64_t named = 0;  // frames, with repetitions
  for (bool more = true; more;) {
    more = range.find(',') != std::string_view::npos;
    const std::string_view part = take_until(range, ',');
    const auto run = parse_run(part);
    if (!run) {
      throw InvalidArgument(
          what, fmt::format("'{}' is not a frame or a range of frames", part),
          "write a, a-b or a-b:step with a <= b and step >= 1, separated by commas: "
          "0-99,200-300:10");
    }
    if (run->last >= frame_count) {
      throw InvalidArgument(what, fmt::format("there is no frame {}", run->last),
                            fmt::format("the video's frames are 0-{}", frame_count - 1));
    }
    named += (run->last - run->first) / run->step + 1;
    if (named > most_named) {
      throw InvalidArgument(
          what, fmt::format("it lists more than {} frames, including repetitions", most_named));
    }
    runs.push_back(*run);
  }
  return runs;
}

}  // namespace

void check_frame_range(std::string_view range, int frame_count) { parse_runs(range, frame_count); }

std::vector<int> parse_frame_range(std::string_view range, int frame_count) {
  std::vector<bool> selected;  // as long as the largest number requires
  for (const Run& run : parse_runs(range, frame_count)) {
    const auto length = static_cast<std::size_t>(run.last) + 1;
    selected.resize(std::max(selected.size(), length));
    for (std::int64_t frame = run.first; frame <= run.last; frame += run.step) {
      selected[static_cast<std::size_t>(frame)] = true;
    }
  }
  std::vector<int> frames;
  for (std::size_t frame = 0; frame < selected.size(); ++frame) {
    if (selected[frame]) {
      frames.push_back(static_cast<int>(frame));
    }
  }
  return frames;
}

std::string format_frame_range(std::span<const int> frames) {
  std::string text;
  for (std::size_t i = 0; i < frames.size();) {
    std::size_t end = i + 1;
    while (end < frames.size() && frames[end] == frames[end - 1] + 1) {
      ++end;
    }
    text += text.empty() ? "" : ",";
    text += end - i == 1 ? fmt::format("{}", frames[i])
                         : fmt::format("{}-{}", frames[i], frames[end - 1]);
    i = end;
  }
  return text;
}

std::string brief_frame_range(std::span<const int> frames) {
  constexpr std::size_t longest = 120;
  std::string all = format_frame_range(frames);
  if (all.size() <= longest) return all;
  return fmt::format("{},... ({} in all)", all.substr(0, all.rfind(',', longest)), frames.size());
}

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
