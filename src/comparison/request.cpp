#include "comparison/request.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include <optional>
#include <string>

#include "comparison/page.h"
#include "image/png.h"
#include "system/file.h"
#include "system/output.h"

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

/// A wrong name may be that of another file, such as the manifest of the frames.
void require_ending(const std::string& option, const std::string& file, const std::string& ending) {
  if (file.empty() || std::filesystem::path(file).extension() == ending) return;
  throw InvalidArgument(option + " " + file, "its name must end in " + ending);
}

/// Throws OverwriteError if an output would replace an input.
void require_free_outputs(const Request& request, const Inputs& inputs) {
  system::require_different_outputs(request.difference, request.page);
  for (const std::string& output : {request.difference, request.page}) {
    if (output == "-")
      throw InvalidArgument("compare", "standard output is used for the results", "name a file");
    if (output.empty()) continue;
    system::require_not_input(output, inputs.expected);
    system::require_not_input(output, inputs.actual);
    if (!inputs.folders) continue;
    for (const FrameName& frame : frames_of(inputs)) {
      system::require_not_input(output, inputs.expected_frame(frame.name));
      system::require_not_input(output, inputs.actual_frame(frame.name));
    }
  }
}

Comparison compare_two_files(const Request& request, const Inputs& files,
                             const Criteria& criteria) {
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
    if (!request.difference.empty() && frame.outcome != Outcome::other_format) {
      PicturePair pair(a, b);
      pair.ignore(criteria.ignored);
      system::write_file_atomically(request.difference,
                                    image::encode_png(pair.difference_image(criteria.edges)));
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
    throw InvalidArgument("--diff", "it is for two files",
                          "--report FILE.html shows the differences of folders");
  }
  require_free_outputs(request, inputs);
  require_ending("--diff", request.difference, ".png");
  require_ending("--report", request.page, ".html");
  std::optional<system::Output> page;  // opened before the work, which may take minutes
  if (!request.page.empty()) page.emplace(request.page);
  Comparison comparison = inputs.folders ? compare_folders(inputs, request.criteria, progress)
                                         : compare_two_files(request, inputs, request.criteria);
  if (page) {
    write_page(comparison, [&](std::string_view text) { page->write(text); });
    page->finish();
  }
  return comparison;
}

}  // namespace twrench::comparison
