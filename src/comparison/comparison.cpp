#include "comparison/comparison.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include <algorithm>
#include <mutex>
#include <system_error>

#include "base/parallel.h"
#include "base/words.h"
#include "comparison/report.h"
#include "image/png.h"
#include "system/file.h"
#include "system/file_lock.h"
#include "system/output.h"
#include "system/pending_file.h"

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

namespace {

/// Whether the path is a folder. Throws FileError if it does not exist.
bool is_folder(const std::filesystem::path& path) {
  std::error_code failed;
  const auto status = std::filesystem::status(path, failed);
  if (status.type() == std::filesystem::file_type::not_found ||
      status.type() == std::filesystem::file_type::none) {
    throw system::file_error("cannot read " + path.string(), failed.value(), system::Access::read);
  }
  return std::filesystem::is_directory(status);
}

Inputs inputs_of(const Request& request) {
  const bool actual_is_folder = is_folder(request.actual);
  std::error_code unknown;
  const bool is_new = request.may_be_new && !std::filesystem::exists(request.expected, unknown);
  if (!is_new && is_folder(request.expected) != actual_is_folder) {
    const auto kind = [](bool folder) { return folder ? "a folder" : "a file"; };
    throw InvalidArgument(
        "compare",
        fmt::format("{} is {}, but {} is {}", request.expected.string(), kind(!actual_is_folder),
                    request.actual.string(), kind(actual_is_folder)),
        "name two files, or two folders of frames");
  }
  return {request.expected, request.actual, actual_is_folder};
}

/// The files that a request writes, besides accepted frames.
struct OutputFiles {
  std::optional<system::OutputFile> difference, page;
};

/// Throws OverwriteError if an output would replace an input or another's file.
OutputFiles output_files(const Request& request, const Inputs& inputs) {
  system::FileList files(request.overwrite);
  files.add_input(inputs.expected);
  files.add_input(inputs.actual);
  if (inputs.folders) {
    for (const FrameName& frame : frames_of(inputs)) {
      files.add_input(inputs.expected_frame(frame.name));
      files.add_input(inputs.actual_frame(frame.name));
    }
  }
  const auto add = [&](const char* name, const std::string& file,
                       const system::OutputKind& kind) -> std::optional<system::OutputFile> {
    if (file == "-") {
      throw InvalidArgument(argument(name), "standard output is used for the results",
                            "name a file");
    }
    if (file.empty()) return std::nullopt;
    return files.add_output(kind, file);
  };
  return {add("diff", request.difference, system::difference_picture),
          add("report", request.page, system::comparison_page)};
}

Comparison compare_two_files(const Request& request, const Inputs& files,
                             const std::optional<system::OutputFile>& difference) {
  const Criteria& criteria = request.criteria;
  FrameResult frame;
  const auto actual = system::read_file(files.actual, image::max_png_size);
  std::error_code unknown;
  if (request.may_be_new && !std::filesystem::exists(files.expected, unknown)) {
    image::require_whole_png(actual, files.actual.string());
    frame.outcome = Outcome::extra;
  } else {
    const auto expected = system::read_file(files.expected, image::max_png_size);
    const PngFile a{expected, files.expected.string()}, b{actual, files.actual.string()};
    frame = compare_pictures(a, b, criteria);
    if (difference && frame.outcome != Outcome::other_format) {
      PicturePair pair(a, b);
      pair.ignore(criteria.ignored);
      const auto png = image::encode_png(pair.difference_image(criteria.edges), "twrench");
      system::write_output(*difference, {reinterpret_cast<const char*>(png.data()), png.size()});
    }
  }
  frame.name = files.actual.filename().string();
  return {files, criteria, {frame}};
}

}  // namespace

Comparison compare(const Request& request,
                   const std::function<void(int done, int total)>& progress) {
  const Inputs inputs = inputs_of(request);
  if (inputs.folders && !request.difference.empty()) {
    throw InvalidArgument(argument("diff"), "it is for two files",
                          argument("report", "FILE.html") + " shows the differences of folders");
  }
  const OutputFiles files = output_files(request, inputs);
  std::optional<system::Output> page;  // opened before the work, which may take minutes
  if (files.page) page.emplace(*files.page);
  Comparison comparison = inputs.folders ? compare_folders(inputs, request.criteria, progress)
                                         : compare_two_files(request, inputs, files.difference);
  if (page) {
    write_page(comparison, [&](std::string_view text) { page->write(text); });
    page->finish();
  }
  return comparison;
}

namespace {

bool is_to_be_copied(const FrameResult& frame) {
  return frame.outcome == Outcome::different || frame.outcome == Outcome::other_format ||
         frame.outcome == Outcome::extra;
}

void copy_frame(const Inputs& inputs, const std::string& name) {
  const auto actual = inputs.actual_frame(name);
  const auto bytes = system::read_regular_file(actual, image::max_png_size);
  image::require_whole_png(bytes, actual.string());
  // In a folder of frames, a link may lead to a file that another folder uses as well.
  system::PendingFile file(inputs.expected_frame(name),
                           inputs.folders ? system::Links::replace : system::Links::follow);
  file.write(bytes);
  file.commit();
}

}  // namespace

std::size_t update_expected(const Comparison& comparison) {
  if (comparison.first_unreadable() != nullptr) return 0;
  std::optional<system::FolderLock> lock;
  if (comparison.inputs.folders) {
    system::make_folder(comparison.inputs.expected);
    lock.emplace(comparison.inputs.expected, system::LockKind::exclusive);
  }
  std::size_t copied = 0;
  for (const FrameResult& frame : comparison.frames) {
    if (!is_to_be_copied(frame)) continue;
    copy_frame(comparison.inputs, frame.name);
    ++copied;
  }
  return copied;
}

}  // namespace twrench::comparison
