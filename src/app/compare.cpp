#include "image/compare.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/arguments.h"
#include "app/commands.h"
#include "app/output.h"
#include "image/png.h"
#include "scene/limits.h"
#include "system/file.h"

namespace twrench::app {
namespace {

struct CompareOptions {
  std::string a, b;
  std::string diff;
  std::string threshold = "0";
  std::string share = "0";
};

ExitCode compare_files(const CompareOptions& options) {
  for (const std::string& input : {options.a, options.b})
    system::require_not_input(options.diff, input);
  const int threshold = scene::limits::check_whole({0, 255}, "--threshold",
                                                   parse_number(options.threshold, "--threshold"));
  const double allowed = scene::limits::check(scene::limits::fraction, "--share",
                                              parse_number(options.share, "--share"));
  const image::DeepImage a = image::read_deep_png(options.a), b = image::read_deep_png(options.b);
  const std::optional<image::Difference> difference = image::compare(a, b, threshold);
  if (!difference) {
    write_output("-", fmt::format("different: {}x{} with {} channels, and {}x{} with {}\n", a.width,
                                  a.height, a.channels, b.width, b.height, b.channels));
    return ExitCode::answer_is_no;
  }
  if (!options.diff.empty()) {
    system::write_file_atomically(options.diff, image::encode_png(image::difference_image(a, b)));
  }
  const bool alike = difference->share <= allowed;
  write_output("-", fmt::format("{}: max {:.6g} mean {:.6f} of 255, {:.6f} of the pixels over {}\n",
                                alike ? "alike" : "different", difference->max, difference->mean,
                                difference->share, threshold));
  return alike ? ExitCode::done : ExitCode::answer_is_no;
}

}  // namespace

void add_compare(CLI::App& app, ExitCode& code) {
  CLI::App* command = app.add_subcommand("compare", "Compare two PNG images");
  command->footer(
      "Example: twrench compare golden.png actual.png --threshold 8 --share 0.001\n"
      "Exit codes: 0 alike, 1 different, 5 an image cannot be read or is damaged.");
  const auto options = std::make_shared<CompareOptions>();
  command->add_option("A", options->a, "PNG file")->required();
  command->add_option("B", options->b, "PNG file")->required();
  command
      ->add_option("--threshold", options->threshold,
                   "largest channel difference, of 255, at which pixels count as equal")
      ->type_name("N")
      ->capture_default_str();
  command->add_option("--share", options->share, "fraction of pixels that may differ, 0 to 1")
      ->type_name("S")
      ->capture_default_str();
  command->add_option("--diff", options->diff, "write the amplified difference to this PNG file")
      ->type_name("D.png");
  command->callback([options, &code] { code = compare_files(*options); });
}

}  // namespace twrench::app
