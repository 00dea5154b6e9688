#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/commands/commands.h"
#include "app/options/arguments.h"
#include "app/terminal/message.h"
#include "app/terminal/output.h"
#include "app/terminal/progress.h"
#include "base/enumeration.h"
#include "comparison/comparison.h"
#include "comparison/page.h"
#include "comparison/report.h"
#include "comparison/update.h"
#include "image/png.h"
#include "scene/limits.h"
#include "system/file.h"

namespace twrench::app {
namespace {

using comparison::Comparison;
using comparison::Criteria;
using comparison::FrameResult;
using comparison::Inputs;
using comparison::Metric;
using comparison::Outcome;

struct CompareOptions {
  explicit CompareOptions(CLI::App& command) : app(command) {}

  CLI::App& app;
  std::string expected, actual;
  std::string metric = "share";
  std::string threshold = "0", share = "0", min_ssim = "1", edges = "0";
  std::vector<std::string> ignored;
  std::string diff, report;
  std::string format = "text";
  bool update = false;
};

/// Parses "X,Y,WxH", in pixels.
image::Area parse_area(const std::string& text, const std::string& what) {
  const std::vector<std::string> words = parse_words(text);
  if (words.size() != 3 || words[2].find('x') == std::string::npos) {
    throw InvalidArgument(what, fmt::format("'{}' is not X,Y,WIDTHxHEIGHT", text));
  }
  const auto whole = [&](double least, double value) {
    return scene::limits::check_whole({least, image::max_image_side}, what, value);
  };
  const Eigen::Vector2d size = parse_size(words[2], what);
  return {whole(0, parse_number(words[0], what)), whole(0, parse_number(words[1], what)),
          whole(1, size.x()), whole(1, size.y())};
}

/// An option that bounds the metric that does not decide would be ignored without a word.
void require_bound_of_metric(const CompareOptions& options, const char* bound, const char* metric) {
  if (options.metric == metric || options.app.count(bound) == 0) return;
  throw InvalidArgument(
      bound, fmt::format("it bounds the metric {}, but {} decides", metric, options.metric),
      fmt::format("omit it, or give --metric {}", metric));
}

Criteria criteria_of(const CompareOptions& options) {
  require_bound_of_metric(options, "--share", "share");
  require_bound_of_metric(options, "--min-ssim", "ssim");
  constexpr int most_edges = 16;
  Criteria criteria;
  criteria.metric = find_enumerator<Metric>(options.metric, "--metric");
  criteria.threshold = parse_whole(options.threshold, "--threshold", {0, 255});
  criteria.share = parse_number(options.share, "--share", scene::limits::fraction);
  criteria.min_similarity = parse_number(options.min_ssim, "--min-ssim", {-1, 1});
  criteria.edges = parse_whole(options.edges, "--edges", {0, most_edges});
  for (const std::string& area : options.ignored) {
    criteria.ignored.push_back(parse_area(area, "--ignore"));
  }
  return criteria;
}

/// Whether it is a folder; throws FileError if it is not there.
bool is_folder(const std::string& path) {
  std::error_code failed;
  const auto status = std::filesystem::status(path, failed);
  if (status.type() == std::filesystem::file_type::not_found ||
      status.type() == std::filesystem::file_type::none) {
    throw system::file_error("cannot read " + path, failed.value(), system::Access::read);
  }
  return std::filesystem::is_directory(status);
}

Inputs inputs_of(const CompareOptions& options) {
  const bool actual_is_folder = is_folder(options.actual);
  std::error_code unknown;
  const bool is_new = options.update && !std::filesystem::exists(options.expected, unknown);
  if (!is_new && is_folder(options.expected) != actual_is_folder) {
    const auto kind = [](bool folder) { return folder ? "a folder" : "a file"; };
    throw InvalidArgument(
        "compare",
        fmt::format("{} is {}, but {} is {}", options.expected, kind(!actual_is_folder),
                    options.actual, kind(actual_is_folder)),
        "name two files, or two folders of frames");
  }
  return {options.expected, options.actual, actual_is_folder};
}

/// Nothing that is written may take the place of what is compared.
void require_free_outputs(const CompareOptions& options, const Inputs& inputs) {
  system::require_different_outputs(options.diff, options.report);
  for (const std::string& output : {options.diff, options.report}) {
    if (output == "-")
      throw InvalidArgument("compare", "standard output is for the findings", "name a file");
    if (output.empty()) continue;
    system::require_not_input(output, inputs.expected);
    system::require_not_input(output, inputs.actual);
    if (!inputs.folders) continue;
    for (const comparison::FrameName& frame : comparison::frames_of(inputs)) {
      system::require_not_input(output, inputs.expected_frame(frame.name));
      system::require_not_input(output, inputs.actual_frame(frame.name));
    }
  }
}

Comparison compare_two_files(const CompareOptions& options, const Inputs& files,
                             const Criteria& criteria) {
  FrameResult frame;
  const auto actual = system::read_file(files.actual, image::max_png_size);
  std::error_code unknown;
  if (options.update && !std::filesystem::exists(files.expected, unknown)) {
    image::require_whole_png(actual, files.actual.string());
    frame.outcome = Outcome::extra;
  } else {
    const auto expected = system::read_file(files.expected, image::max_png_size);
    const comparison::PngFile a{expected, files.expected.string()},
        b{actual, files.actual.string()};
    frame = comparison::compare_pictures(a, b, criteria);
    if (!options.diff.empty() && frame.outcome != Outcome::other_format) {
      comparison::PicturePair pair(a, b);
      pair.ignore(criteria.ignored);
      system::write_file_atomically(options.diff,
                                    image::encode_png(pair.difference_image(criteria.edges)));
    }
  }
  frame.name = files.actual.filename().string();
  return {files, criteria, {frame}};
}

Comparison compare_inputs(const CompareOptions& options, const Inputs& inputs,
                          const Criteria& criteria) {
  if (!inputs.folders) return compare_two_files(options, inputs, criteria);
  Progress progress(isatty(STDERR_FILENO) != 0 ? "auto" : "none");
  Comparison comparison = comparison::compare_folders(
      inputs, criteria, [&](int done, int total) { progress.update(done, total); });
  progress.finish();
  std::error_code unknown;
  if (std::filesystem::equivalent(inputs.expected, inputs.actual, unknown)) {
    warn("both folders are the same one, so nothing can differ");
  }
  return comparison;
}

void write_findings(const std::string& format, const Comparison& comparison) {
  Output output("-");
  const auto write = [&](std::string_view text) { output.write(text); };
  if (format == "json") {
    comparison::write_json(comparison, write);
  } else if (format == "junit") {
    comparison::write_junit(comparison, write);
  } else {
    comparison::write_text(comparison, write);
  }
  output.finish();
}

ExitCode update(const Comparison& comparison) {
  const std::size_t copied = comparison::update_expected(comparison);
  say("twrench: compare: {} {} updated in {}\n", copied, copied == 1 ? "frame was" : "frames were",
      comparison.inputs.expected.string());
  return comparison.count(Outcome::missing) == 0 ? ExitCode::done : ExitCode::answer_is_no;
}

ExitCode compare(const CompareOptions& options) {
  const Criteria criteria = criteria_of(options);
  const Inputs inputs = inputs_of(options);
  if (inputs.folders && !options.diff.empty()) {
    throw InvalidArgument("--diff", "it is for two files",
                          "--report FILE.html shows the differences of folders");
  }
  require_free_outputs(options, inputs);
  std::optional<Output> page;  // opened before the work, which may take minutes
  if (!options.report.empty()) page.emplace(options.report);
  const Comparison comparison = compare_inputs(options, inputs, criteria);
  if (page) {
    comparison::write_page(comparison, [&](std::string_view text) { page->write(text); });
    page->finish();
  }
  write_findings(options.format, comparison);
  if (const FrameResult* frame = comparison.first_unreadable()) throw *frame->failure;
  if (options.update && !comparison.passed()) return update(comparison);
  return comparison.passed() ? ExitCode::done : ExitCode::answer_is_no;
}

void add_bounds(CLI::App& command, CompareOptions& options) {
  command
      .add_option("--metric", options.metric,
                  "what decides: share, of pixels that differ, or ssim, structural similarity")
      ->check(one_of("--metric", enumerator_names<Metric>()))
      ->type_name("METRIC")
      ->capture_default_str();
  command
      .add_option("--threshold", options.threshold,
                  "largest channel difference, of 255, at which pixels count as equal")
      ->type_name("N")
      ->capture_default_str();
  command.add_option("--share", options.share, "fraction of pixels that may differ, 0 to 1")
      ->type_name("S")
      ->capture_default_str();
  command.add_option("--min-ssim", options.min_ssim, "least structural similarity, up to 1")
      ->type_name("S")
      ->capture_default_str();
  command
      .add_option("--edges", options.edges,
                  "edges may lie N pixels elsewhere: a pixel may match any of its neighbours")
      ->type_name("N")
      ->capture_default_str();
  command
      .add_option("--ignore", options.ignored,
                  "rectangle, in pixels from the top left, that counts as equal; may be repeated")
      ->type_name("X,Y,WxH")
      ->expected(1)
      ->allow_extra_args(false)
      ->take_all();
}

void add_outputs(CLI::App& command, CompareOptions& options) {
  command
      .add_option("--diff", options.diff,
                  "for two files: write the amplified difference to this PNG file")
      ->type_name("D.png");
  command
      .add_option("--report", options.report,
                  "write a page that shows what differs, the worst first, with its pictures")
      ->type_name("R.html");
  add_format_option(command, options.format, {"text", "json", "junit"});
  command.add_flag("--update", options.update,
                   "copy the actual frames that differ, or are extra, over the expected ones");
}

}  // namespace

void add_compare(CLI::App& app, ExitCode& code) {
  CLI::App* command =
      app.add_subcommand("compare", "Compare two PNG images, or two folders of frames");
  command->footer(
      "Example: twrench compare golden.png actual.png --threshold 8 --share 0.001\n"
      "Example: twrench compare golden out/dzhanibekov --edges 1 --report report.html\n"
      "Exit codes: 0 alike, 1 different, 5 an image cannot be read or is damaged.");
  const auto options = std::make_shared<CompareOptions>(*command);
  command->add_option("EXPECTED", options->expected, "PNG file, or folder of PNG files")
      ->required();
  command->add_option("ACTUAL", options->actual, "the same, compared with it by file names")
      ->required();
  add_bounds(*command, *options);
  add_outputs(*command, *options);
  command->callback([options, &code] { code = compare(*options); });
}

}  // namespace twrench::app
