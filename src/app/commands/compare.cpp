#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "app/commands/commands.h"
#include "app/options/arguments.h"
#include "app/options/command_line.h"
#include "app/terminal/message.h"
#include "app/terminal/progress.h"
#include "base/enumeration.h"
#include "comparison/comparison.h"
#include "comparison/report.h"
#include "image/png.h"
#include "scene/limits.h"
#include "system/output.h"

namespace twrench::app {
namespace {

using comparison::Comparison;
using comparison::Criteria;
using comparison::FrameResult;
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
  bool overwrite = false;
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

/// A bound on the metric that does not decide would be ignored silently.
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

comparison::Request request_of(const CompareOptions& options) {
  return {options.expected, options.actual, criteria_of(options), options.diff,
          options.report,   options.update, options.overwrite};
}

Comparison compare_with_progress(const comparison::Request& request) {
  Progress progress(isatty(STDERR_FILENO) != 0 ? "auto" : "none");
  const Comparison comparison =
      comparison::compare(request, [&](int done, int total) { progress.update(done, total); });
  if (comparison.inputs.folders) {
    progress.finish();
    std::error_code unknown;
    if (std::filesystem::equivalent(request.expected, request.actual, unknown)) {
      warn("both folders are the same one, so nothing can differ");
    }
  }
  return comparison;
}

void write_findings(const std::string& format, const Comparison& comparison) {
  system::Output output;
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
  return comparison.count(Outcome::missing) == 0 ? ExitCode::done : ExitCode::negative;
}

ExitCode compare(const CompareOptions& options) {
  const Comparison comparison = compare_with_progress(request_of(options));
  write_findings(options.format, comparison);
  if (const FrameResult* frame = comparison.first_unreadable()) throw *frame->failure;
  if (options.update && !comparison.passed()) return update(comparison);
  return comparison.passed() ? ExitCode::done : ExitCode::negative;
}

void add_bounds(CLI::App& command, CompareOptions& options) {
  command
      .add_option(
          "--metric", options.metric,
          "metric that decides: share (of differing pixels) or ssim (structural similarity)")
      ->check(one_of("--metric", enumerator_names<Metric>()))
      ->type_name("METRIC")
      ->capture_default_str()
      ->group(heading(OptionGroup::bounds));
  command
      .add_option("--threshold", options.threshold,
                  "largest channel difference, 0 to 255, at which pixels count as equal")
      ->type_name("N")
      ->capture_default_str()
      ->group(heading(OptionGroup::bounds));
  command.add_option("--share", options.share, "fraction of pixels that may differ, 0 to 1")
      ->type_name("S")
      ->capture_default_str()
      ->group(heading(OptionGroup::bounds));
  command.add_option("--min-ssim", options.min_ssim, "least structural similarity, up to 1")
      ->type_name("S")
      ->capture_default_str()
      ->group(heading(OptionGroup::bounds));
  command
      .add_option("--edges", options.edges,
                  "tolerate edges displaced by up to N pixels: a pixel may match any neighbour")
      ->type_name("N")
      ->capture_default_str()
      ->group(heading(OptionGroup::bounds));
  command
      .add_option("--ignore", options.ignored,
                  "rectangle, in pixels from the top left, that counts as equal; may be repeated")
      ->type_name("X,Y,WxH")
      ->expected(1)
      ->allow_extra_args(false)
      ->take_all()
      ->group(heading(OptionGroup::bounds));
}

void add_outputs(CLI::App& command, CompareOptions& options) {
  command
      .add_option("--diff", options.diff,
                  "for two files: write the amplified difference to this PNG file")
      ->type_name("D.png")
      ->group(heading(OptionGroup::output));
  command
      .add_option("--report", options.report,
                  "write a page with the differing pictures, the worst first")
      ->type_name("R.html")
      ->group(heading(OptionGroup::output));
  add_format_option(command, options.format, {"text", "json", "junit"});
  add_overwrite_option(command, options.overwrite);
  command
      .add_flag("--update", options.update,
                "replace the expected frames that differ with the actual ones, and add extra ones")
      ->group(heading(OptionGroup::output));
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
