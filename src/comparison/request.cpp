#include "comparison/request.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include <optional>

#include "base/argument.h"
#include "comparison/page.h"
#include "image/png.h"
#include "system/file.h"
#include "system/file_list.h"
#include "system/file_lock.h"
#include "system/output.h"
#include "system/pending_file.h"

namespace twrench::comparison {
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
