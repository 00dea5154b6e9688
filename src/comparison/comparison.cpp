#include "comparison/comparison.h"

#include <twrench/base/error.h>

#include <algorithm>
#include <mutex>
#include <system_error>

#include "base/parallel.h"
#include "base/words.h"
#include "image/picture_memory.h"
#include "image/png.h"
#include "system/file.h"

namespace twrench::comparison {
namespace {

namespace fs = std::filesystem;

bool is_frame_name(const std::string& name) {
  const std::string ending = to_lower(fs::path(name).extension().string());
  return ending == ".png" && !name.starts_with('.');
}

std::vector<std::string> frame_names(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code failed;
  auto entry = fs::directory_iterator(folder, failed);
  if (failed == std::errc::no_such_file_or_directory) return names;
  for (; !failed && entry != fs::directory_iterator(); entry.increment(failed)) {
    std::string name = entry->path().filename().string();
    std::error_code unknown;
    if (is_frame_name(name) && !entry->is_directory(unknown)) names.push_back(std::move(name));
  }
  if (failed) {
    throw system::file_error("cannot read the folder " + folder.string(), failed.value(),
                             system::Access::read);
  }
  std::ranges::sort(names);
  return names;
}

}  // namespace

fs::path Inputs::expected_frame(const std::string& name) const {
  return folders ? expected / name : expected;
}

fs::path Inputs::actual_frame(const std::string& name) const {
  return folders ? actual / name : actual;
}

std::vector<FrameName> frames_of(const Inputs& folders) {
  std::vector<FrameName> frames;
  for (std::string& name : frame_names(folders.expected)) {
    frames.push_back({std::move(name), true, false});
  }
  const auto middle = static_cast<std::ptrdiff_t>(frames.size());
  for (std::string& name : frame_names(folders.actual)) {
    const auto end = frames.begin() + middle;
    const auto found = std::ranges::lower_bound(frames.begin(), end, name, {}, &FrameName::name);
    if (found != end && found->name == name) {
      found->is_actual = true;
    } else {
      frames.push_back({std::move(name), false, true});
    }
  }
  std::ranges::inplace_merge(frames, frames.begin() + middle, {}, &FrameName::name);
  return frames;
}

namespace {

bool within_bounds(const FrameResult& frame, const Criteria& criteria) {
  return criteria.metric == Metric::ssim ? *frame.similarity >= criteria.min_similarity
                                         : frame.difference.share <= criteria.share;
}

FrameResult identical(const PngFile& file, const Criteria& criteria) {
  image::require_whole_png(file.bytes, file.name);
  const image::PngHeader header = image::png_header(file.bytes);
  require_within(criteria.ignored, static_cast<int>(header.width), static_cast<int>(header.height),
                 file.name);
  FrameResult frame;
  if (criteria.metric == Metric::ssim) frame.similarity = 1.0;
  return frame;
}

FrameResult compare_files(const Inputs& folders, const std::string& name,
                          const Criteria& criteria) {
  const auto expected_path = folders.expected_frame(name), actual_path = folders.actual_frame(name);
  const auto expected = system::read_regular_file(expected_path, image::max_png_size);
  const auto actual = system::read_regular_file(actual_path, image::max_png_size);
  if (expected == actual) return identical({expected, expected_path.string()}, criteria);
  return compare_pictures({expected, expected_path.string()}, {actual, actual_path.string()},
                          criteria);
}

/// A frame that one of the folders lacks. The file in the other one must be complete nevertheless.
FrameResult unpaired(const std::filesystem::path& path, Outcome outcome) {
  image::require_whole_png(system::read_regular_file(path, image::max_png_size), path.string());
  FrameResult frame;
  frame.outcome = outcome;
  return frame;
}

FrameResult result_of(const Inputs& folders, const FrameName& frame, const Criteria& criteria) {
  if (!frame.is_actual) return unpaired(folders.expected_frame(frame.name), Outcome::missing);
  if (!frame.is_expected) return unpaired(folders.actual_frame(frame.name), Outcome::extra);
  return compare_files(folders, frame.name, criteria);
}

FrameResult compare_frame(const Inputs& folders, const FrameName& frame, const Criteria& criteria) {
  FrameResult result;
  try {
    result = result_of(folders, frame, criteria);
  } catch (const system::FileError& error) {
    result.outcome = Outcome::unreadable;
    result.failure = std::make_shared<const system::FileError>(error);
  }
  result.name = frame.name;
  return result;
}

}  // namespace

FrameResult compare_pictures(const PngFile& expected, const PngFile& actual,
                             const Criteria& criteria) {
  PicturePair pair(expected, actual);
  FrameResult frame;
  frame.notes = pair.notes();
  if (!pair.same_format()) {
    frame.outcome = Outcome::other_format;
    frame.formats = pair.formats();
    return frame;
  }
  pair.ignore(criteria.ignored);
  frame.difference = pair.difference(criteria.threshold, criteria.edges);
  if (criteria.metric == Metric::ssim) frame.similarity = pair.similarity();
  frame.outcome = within_bounds(frame, criteria) ? Outcome::alike : Outcome::different;
  return frame;
}

std::size_t Comparison::count(Outcome outcome) const {
  return static_cast<std::size_t>(std::ranges::count(frames, outcome, &FrameResult::outcome));
}

bool Comparison::passed() const { return std::ranges::all_of(frames, &FrameResult::passed); }

const FrameResult* Comparison::first_unreadable() const {
  const auto found = std::ranges::find(frames, Outcome::unreadable, &FrameResult::outcome);
  return found == frames.end() ? nullptr : &*found;
}

Comparison compare_folders(const Inputs& folders, const Criteria& criteria,
                           const std::function<void(int done, int total)>& progress) {
  const std::vector<FrameName> names = frames_of(folders);
  if (names.empty()) {
    throw system::FileError(
        "cannot compare " + folders.expected.string() + " with " + folders.actual.string(),
        "neither has a frame, a file called *.png");
  }
  image::keep_memory_of_pictures(1920, 1080);  // larger ones are slow in any case
  Comparison comparison{folders, criteria, std::vector<FrameResult>(names.size())};
  std::mutex mutex;
  int done = 0;
  for_each_part(names.size(), 1, 0, [&](std::size_t begin, std::size_t) {
    comparison.frames[begin] = compare_frame(folders, names[begin], criteria);
    const std::lock_guard lock(mutex);
    if (progress) progress(++done, static_cast<int>(names.size()));
  });
  return comparison;
}

}  // namespace twrench::comparison
