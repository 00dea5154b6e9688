#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <numbers>

#include "app/commands/commands.h"
#include "app/options/arguments.h"
#include "app/options/check_setup.h"
#include "app/reports/check_report.h"
#include "app/terminal/message.h"
#include "app/terminal/output.h"
#include "check/verdict/error.h"
#include "plot/check_plot.h"
#include "scene/limits.h"
#include "study/ladder.h"
#include "system/file.h"

namespace twrench::app {
namespace {

struct CheckOptions {
  CheckSetup setup;
  std::vector<std::string> files;
  std::string steps;
  std::string max_attitude_error, max_rate_error, max_energy_drift;
  std::string format = "text";
  std::string output = "-";
  std::string plot;
  bool no_fail = false;
};

double parse_bound(const std::string& text, const std::string& option) {
  return parse_number(text, option, {0.0, scene::limits::huge});
}

/// Throws InvalidArgument where a bound is for what the file does not have.
[[noreturn]] void refuse_bound(const std::string& option, const std::string& file,
                               const char* missing) {
  throw InvalidArgument(option, fmt::format("{} has no {} to hold against it", file, missing),
                        "leave the option out");
}

std::vector<CheckBound> bounds_of(const CheckOptions& options, const std::string& file,
                                  const check::Judgement& judgement) {
  std::vector<CheckBound> bounds;
  if (!options.max_attitude_error.empty()) {
    const std::string name = "--max-attitude-error";
    if (!judgement.attitude) refuse_bound(name, file, "attitude");
    bounds.push_back({name, "deg", parse_bound(options.max_attitude_error, name),
                      degrees(judgement.attitude->max)});
  }
  if (!options.max_rate_error.empty()) {
    const std::string name = "--max-rate-error";
    const RateScale unit = rate_scale(judgement);
    if (!judgement.rates) refuse_bound(name, file, "rates");
    bounds.push_back({name, unit.symbol, parse_bound(options.max_rate_error, name),
                      judgement.rates->max * unit.per_radian});
  }
  if (!options.max_energy_drift.empty()) {
    const std::string name = "--max-energy-drift";
    bounds.push_back(
        {name, "", parse_bound(options.max_energy_drift, name), judgement.energy_drift});
  }
  return bounds;
}

/// Before any file is read.
void check_bounds(const CheckOptions& options) {
  for (const auto& [text, name] : {std::pair(options.max_attitude_error, "--max-attitude-error"),
                                   std::pair(options.max_rate_error, "--max-rate-error"),
                                   std::pair(options.max_energy_drift, "--max-energy-drift")}) {
    if (!text.empty()) parse_bound(text, name);
  }
}

/// The fit of the initial state, if the rows begin in another state than the given one.
std::optional<check::Fit> other_start_of(const CheckedFile& file, check::Problem problem) try {
  if (verdict(file).finding != Finding::start) return std::nullopt;
  problem.omega.reset();
  problem.fit = true;
  return check::judge(file.name, file.judgement.convention, problem).fit;
} catch (const check::CheckError&) {
  return std::nullopt;  // it is at rest
}

CheckedFile check_file(const CheckOptions& options, const check::Problem& problem,
                       const std::string& name) {
  const check::Convention convention = options.setup.convention(name, problem);
  CheckedFile file{name, check::judge(name, convention, problem), {}, {}, {}, 0};
  file.alternatives = check::better_readings(name, problem, file.judgement);
  file.other_start = other_start_of(file, problem);
  file.bounds = bounds_of(options, name, file.judgement);
  if (file.judgement.rows > 1) {
    file.step = (file.judgement.last_time - file.judgement.first_time) /
                static_cast<double>(file.judgement.rows - 1);
  }
  return file;
}

std::vector<double> given_steps(const CheckOptions& options) {
  if (options.steps.empty()) return {};
  const std::vector<double> steps = parse_numbers(options.steps, "--steps");
  for (const double step : steps) scene::limits::check(scene::limits::step, "--steps", step);
  if (steps.size() == options.files.size()) return steps;
  throw InvalidArgument(
      "--steps", fmt::format("has {} step sizes for {} files", steps.size(), options.files.size()));
}

/// The exponent of the errors that the digits do not explain and that still grow: those of rates
/// are at most about |omega|, those of attitudes half a turn.
std::optional<double> order(const std::vector<CheckedFile>& files,
                            std::optional<check::ErrorSize> check::Judgement::*errors) {
  std::vector<study::PowerLawPoint> points;
  for (const CheckedFile& file : files) {
    const auto& size = file.judgement.*errors;
    const double speed = file.judgement.reference.body.omega().norm();
    const double most = errors == &check::Judgement::rates ? speed / 2 : std::numbers::pi / 2;
    if (size && size->max > 0 && size->max < most && !file.judgement.within_digits) {
      points.push_back({file.step, size->max});
    }
  }
  return study::fitted_exponent(points);
}

/// Why the files tell no order, where they cannot.
std::string why_no_order(const std::vector<CheckedFile>& files, bool has_steps) {
  const auto [least, most] = std::ranges::minmax_element(files, {}, &CheckedFile::step);
  constexpr double alike = 1.01;
  if (most->step <= alike * least->step) {
    return has_steps ? "the step sizes that --steps gives are the same"
                     : "the files have the same time between rows; --steps tells their step sizes";
  }
  const auto end = [](const CheckedFile& file) { return file.judgement.last_time; };
  const auto [first, last] = std::ranges::minmax_element(files, {}, end);
  if (end(*last) - end(*first) > 1.5 * most->step) return "the files end at different times";
  return {};
}

CheckOrders orders_of(const std::vector<CheckedFile>& files, bool has_steps) {
  if (files.size() < 2) return {};
  CheckOrders orders{{}, {}, why_no_order(files, has_steps)};
  if (!orders.why_not.empty()) return orders;
  orders.rates = order(files, &check::Judgement::rates);
  orders.attitude = order(files, &check::Judgement::attitude);
  if (!orders.rates && !orders.attitude) {
    orders.why_not =
        "fewer than two files have errors that their digits do not explain and that can still grow";
  }
  return orders;
}

CheckResult check_files(const CheckOptions& options) {
  const std::vector<double> steps = given_steps(options);
  const check::Problem problem = options.setup.problem();
  CheckResult result;
  for (std::size_t i = 0; i < options.files.size(); ++i) {
    result.files.push_back(check_file(options, problem, options.files[i]));
    if (!steps.empty()) result.files.back().step = steps[i];
  }
  result.orders = orders_of(result.files, !steps.empty());
  return result;
}

std::string report(const CheckOptions& options, const CheckResult& result) {
  if (options.format == "json") return check_json(result);
  return options.format == "junit" ? check_junit(result) : check_text(result);
}

void draw(const std::string& path, const CheckResult& result) {
  std::vector<plot::JudgedCurve> curves;
  for (const CheckedFile& file : result.files) {
    curves.push_back({std::filesystem::path(file.name).filename().string(), &file.judgement});
  }
  plot::draw_plot(path, plot::check_plot(curves));
}

/// Says which bounds were exceeded.
ExitCode answer(const CheckResult& result, bool no_fail) {
  for (const CheckedFile& file : result.files) {
    for (const CheckBound& bound : file.bounds) {
      if (!bound.is_exceeded()) continue;
      say("twrench: check: {}: {} {} was exceeded: {:.6g}{}{}\n", file.name, bound.option,
          bound.most, bound.value, bound.unit.empty() ? "" : " ", bound.unit);
    }
  }
  const bool all_pass = std::ranges::all_of(result.files, passes);
  return all_pass || no_fail ? ExitCode::done : ExitCode::answer_is_no;
}

ExitCode run_check(const CheckOptions& options) {
  system::require_different_outputs(options.output, options.plot);
  for (const std::string& file : options.files) {
    system::require_not_input(options.output, file);
    system::require_not_input(options.plot, file);
  }
  options.setup.require_not_input(options.output);
  options.setup.require_not_input(options.plot);
  if (!options.plot.empty()) plot::require_gnuplot(options.plot);
  check_bounds(options);
  const CheckResult result = check_files(options);
  Output output(options.output);  // write both it and the plot, or neither
  output.write(report(options, result));
  if (!options.plot.empty()) draw(options.plot, result);
  output.finish();
  return answer(result, options.no_fail);
}

void add_result_options(CLI::App& command, CheckOptions& options) {
  command.add_option("--steps", options.steps, "step sizes of the files, s, for the order")
      ->type_name("H1,H2,...")
      ->default_str("the time between rows");
  command
      .add_option("--max-attitude-error", options.max_attitude_error,
                  "exit 1 if the attitude is off by more, deg")
      ->type_name("DEG");
  command
      .add_option("--max-rate-error", options.max_rate_error,
                  "exit 1 if a rate is off by more, in the file's unit")
      ->type_name("E");
  command
      .add_option("--max-energy-drift", options.max_energy_drift,
                  "exit 1 if the energy drifts by more, relative")
      ->type_name("E");
  command.add_flag("--no-fail", options.no_fail, "exit 0 whatever the verdict");
  add_format_option(command, options.format, {"text", "json", "junit"});
  add_output_option(command, options.output);
  command
      .add_option("--plot", options.plot,
                  "plot errors and resolution limits against time: .svg, .pdf or .png")
      ->type_name("FILE");
}

}  // namespace

void add_check(CLI::App& app, ExitCode& code) {
  CLI::App* command =
      app.add_subcommand("check", "Judge a motion that another program computed, by the exact one");
  command->footer(
      "Example: twrench check run.csv --inertia 2,3,4 --units deg --max-rate-error 1e-6\n"
      "Exit codes: 0 the data follow the exact motion within their digits and noise, or within the "
      "given --max-... bounds; 1 they do not; 2 the file or the options cannot be used.");
  const auto options = std::make_shared<CheckOptions>();
  command
      ->add_option("FILE", options->files,
                   "CSV, TSV, JSON or .npy file of times and rates, attitudes or both")
      ->required()
      ->expected(1, 1000);
  options->setup.add_options(*command);
  add_result_options(*command, *options);
  command->callback([options, &code] { code = run_check(*options); });
}

}  // namespace twrench::app
