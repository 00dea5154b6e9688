#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/commands/commands.h"
#include "app/options/arguments.h"
#include "app/options/check_setup.h"
#include "app/options/command_line.h"
#include "app/terminal/message.h"
#include "check/report/checked_file.h"
#include "check/report/report.h"
#include "plot/plots.h"
#include "scene/limits.h"
#include "system/file.h"
#include "system/output.h"

namespace twrench::app {
namespace {

struct CheckOptions {
  explicit CheckOptions(CLI::App& command) : output(command, system::check_output) {}

  CheckSetup setup;
  std::vector<std::string> files;
  std::string steps;
  std::string max_attitude_error, max_rate_error, max_energy_drift;
  OutputOptions output;
  std::string plot;
  bool no_fail = false;
};

std::optional<double> parse_bound(const std::string& text, const std::string& option) {
  if (text.empty()) return std::nullopt;
  return parse_number(text, option, {0.0, scene::limits::huge});
}

check::Bounds bounds_of(const CheckOptions& options) {
  return {.attitude_error = parse_bound(options.max_attitude_error, "--max-attitude-error"),
          .rate_error = parse_bound(options.max_rate_error, "--max-rate-error"),
          .energy_drift = parse_bound(options.max_energy_drift, "--max-energy-drift")};
}

std::vector<double> given_steps(const CheckOptions& options) {
  if (options.steps.empty()) return {};
  const std::vector<double> steps = parse_numbers(options.steps, "--steps");
  for (const double step : steps) scene::limits::check(scene::limits::step, "--steps", step);
  return steps;
}

std::string report(std::string_view format, const check::CheckResult& result) {
  if (format == "json") return check::check_json(result, option_text);
  return format == "junit" ? check::check_junit(result, option_text)
                           : check::check_text(result, option_text);
}

void draw(const system::OutputFile& file, const check::CheckResult& result) {
  std::vector<plot::JudgedCurve> curves;
  for (const check::CheckedFile& checked : result.files) {
    curves.push_back({std::filesystem::path(checked.name).filename().string(), &checked.judgement});
  }
  plot::draw_plot(file, plot::check_plot(curves));
}

/// Reports the exceeded bounds.
ExitCode answer(const check::CheckResult& result, bool no_fail) {
  for (const check::CheckedFile& file : result.files) {
    for (const check::CheckBound& bound : file.bounds) {
      if (!bound.is_exceeded()) continue;
      say("twrench: check: {}: {} {} was exceeded: {}{}{}\n", file.name,
          option_text(bound.argument, {}), bound.most, check::change_text("{:.6g}", bound.value),
          bound.unit.empty() ? "" : " ", bound.unit);
    }
  }
  const bool all_pass = std::ranges::all_of(result.files, check::passes);
  return all_pass || no_fail ? ExitCode::done : ExitCode::negative;
}

ExitCode run_check(const CheckOptions& options) {
  system::FileList files = options.output.files();
  for (const std::string& file : options.files) files.add_input(file);
  options.setup.add_inputs(files);
  const system::OutputFile file = options.output.add_to(files);
  const std::optional<system::OutputFile> plot_file = plot::add_plot(files, options.plot);
  const recording::Extract extract = options.setup.extract();
  const auto open = [&](std::size_t i) {
    return recording::Recording(options.files[i]).between(extract);
  };
  const check::CheckResult result =
      check::check_files(options.files.size(), open, given_steps(options),
                         options.setup.convention(), options.setup.problem(), bounds_of(options));
  system::Output output(file);  // write both it and the plot, or neither
  output.write(report(file.format().name, result));
  if (plot_file) draw(*plot_file, result);
  output.finish();
  return answer(result, options.no_fail);
}

void add_result_options(CLI::App& command, CheckOptions& options) {
  command.add_option("--steps", options.steps, "step sizes of the files, s, for the order")
      ->type_name("H1,H2,...")
      ->default_str("the time between rows")
      ->group(heading(OptionGroup::motion));
  command
      .add_option("--max-attitude-error", options.max_attitude_error,
                  "exit 1 if the error of the attitude exceeds this, deg")
      ->type_name("DEG")
      ->group(heading(OptionGroup::bounds));
  command
      .add_option("--max-rate-error", options.max_rate_error,
                  "exit 1 if the error of a rate exceeds this, in the file's unit")
      ->type_name("E")
      ->group(heading(OptionGroup::bounds));
  command
      .add_option("--max-energy-drift", options.max_energy_drift,
                  "exit 1 if the energy drifts by more, relative")
      ->type_name("E")
      ->group(heading(OptionGroup::bounds));
  command.add_flag("--no-fail", options.no_fail, "exit 0 whatever the verdict")
      ->group(heading(OptionGroup::bounds));
  command
      .add_option("--plot", options.plot,
                  "plot errors and resolution limits against time: .svg, .pdf or .png")
      ->type_name("FILE")
      ->group(heading(OptionGroup::output));
}

}  // namespace

void add_check(CLI::App& app, ExitCode& code) {
  CLI::App* command =
      app.add_subcommand("check", "Judge a motion that another program computed, by the exact one");
  command->footer(
      "Example: twrench check run.csv --inertia 2,3,4 --units deg --max-rate-error 1e-6\n"
      "Exit codes: 0 the data follow the exact motion within their digits and noise, or within the "
      "given --max-... bounds; 1 they do not; 2 the file or the options cannot be used.");
  const auto options = std::make_shared<CheckOptions>(*command);
  command
      ->add_option("FILE", options->files,
                   "CSV, TSV, JSON, AEM, .npy or .npz file of times and rates, attitudes or both")
      ->required()
      ->expected(1, 1000);
  options->setup.add_options(*command);
  add_result_options(*command, *options);
  command->callback([options, &code] { code = run_check(*options); });
}

}  // namespace twrench::app
