
#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <limits>
#include <memory>
#include <optional>

#include "app/commands/commands.h"
#include "app/options/arguments.h"
#include "app/options/command_line.h"
#include "app/options/scene_options.h"
#include "app/terminal/message.h"
#include "plot/gnuplot.h"
#include "plot/plots.h"
#include "scene/limits.h"
#include "scene/recording_table.h"
#include "study/ladder.h"
#include "system/output.h"
#include "text/escape.h"

namespace twrench::app {
namespace {

struct StudyOptions {
  explicit StudyOptions(CLI::App& command)
      : app(command), scene(command), output(command, system::study_output) {}

  CLI::App& app;
  SceneOptions scene;
  std::string methods, steps, tolerances;
  std::string max_error, max_energy_drift, max_flip_error;
  OutputOptions output;
  std::string plot;
};

std::vector<const motion::Method*> chosen_methods(const StudyOptions& options,
                                                  const scene::Scene& scene) {
  std::vector<const motion::Method*> chosen;
  if (!options.methods.empty()) {
    for (const std::string& name : parse_words(options.methods)) {
      chosen.push_back(&motion::find_method(name, "--methods"));
    }
  } else if (options.app.count("--method") > 0) {
    chosen.push_back(&motion::find_method(scene.motion.method));
  } else {
    const bool has_closed_form = motion::ExactMotion::covers(scene::free_body(scene));
    for (const motion::Method& method : motion::methods()) {
      if (has_closed_form || !method.exact()) chosen.push_back(&method);
    }
  }
  return chosen;
}

/// Returns the given list, or the value of option `single` if given, or `ladder`.
std::vector<double> rungs(const StudyOptions& options, const std::string& name,
                          const std::string& list, const scene::limits::Limit& limit,
                          const std::string& single, double value, std::vector<double> ladder) {
  if (list.empty()) return options.app.count(single) > 0 ? std::vector{value} : std::move(ladder);
  std::vector<double> values = parse_numbers(list, name);
  for (const double v : values) scene::limits::check(limit, name, v);
  std::ranges::sort(values, std::greater<>());
  return values;
}

study::StudyPlan plan_of(const StudyOptions& options, const scene::Scene& scene) {
  const scene::Motion& motion = scene.motion;
  study::StudyPlan plan;
  plan.methods = chosen_methods(options, scene);
  plan.steps = rungs(options, "--steps", options.steps, scene::limits::step, "--step",
                     motion.control.step, study::step_ladder(motion.duration, motion.omega.norm()));
  plan.tolerances = rungs(options, "--tolerances", options.tolerances, scene::limits::tolerance,
                          "--tolerance", motion.control.tolerance, study::tolerance_ladder());
  plan.first_step = plan.steps.front();
  plan.duration = motion.duration;
  // A long or fast motion is not studied to the end of the ladder unless that was requested.
  constexpr std::int64_t most_steps = 1'000'000;
  if (options.steps.empty() && options.tolerances.empty()) plan.max_steps = most_steps;
  return plan;
}

/// An option that sets a bound for a quantity of every run.
struct Bound {
  std::string name;
  double most;
  std::function<double(const study::Study&, const study::StudyRun&)> value;
};

/// A missing or additional flip exceeds every bound.
double flip_error(const study::Study& study, const study::StudyRun& run) {
  if (run.flips.size() != study.flip_times.size()) return std::numeric_limits<double>::infinity();
  return study.flip_times.empty() ? 0.0 : run.flip_error;
}

std::vector<Bound> bounds_of(const StudyOptions& options) {
  std::vector<Bound> bounds;
  const auto add = [&](const std::string& name, const std::string& text, const auto& value) {
    if (text.empty()) return;
    bounds.push_back({name, parse_number(text, name, {0.0, scene::limits::huge}), value});
  };
  add("--max-error", options.max_error,
      [](const study::Study&, const study::StudyRun& r) { return r.error; });
  add("--max-energy-drift", options.max_energy_drift,
      [](const study::Study&, const study::StudyRun& r) { return r.energy_drift; });
  add("--max-flip-error", options.max_flip_error, flip_error);
  return bounds;
}

/// A failed run exceeds every bound.
ExitCode verdict(const study::Study& study, const std::vector<Bound>& bounds) {
  ExitCode code = ExitCode::done;
  for (const Bound& bound : bounds) {
    int over = 0;
    for (const study::MethodStudy& method : study.methods) {
      for (const study::StudyRun& run : method.runs) {
        if (!run.failure.empty() || !(bound.value(study, run) <= bound.most)) ++over;
      }
    }
    if (over == 0) continue;
    code = ExitCode::negative;
    say("twrench: study: {} {} was exceeded in {} of the runs\n", bound.name, bound.most, over);
  }
  return code;
}

std::string report(std::string_view format, const study::Study& study, const std::string& scene) {
  if (format == "csv") return study_csv(study);
  return format == "json" ? study_json(study, scene) : study_text(study, text::escape(scene));
}

ExitCode run_study(const StudyOptions& options) {
  system::FileList files = options.output.files();
  options.scene.add_inputs(files);
  const system::OutputFile file = options.output.add_to(files);
  const std::optional<system::OutputFile> plot_file = plot::add_plot(files, options.plot);
  const std::vector<Bound> bounds = bounds_of(options);
  const scene::Scene scene = options.scene.scene();
  scene::require_computed(scene, "a study");
  study::StudyPlan plan = plan_of(options, scene);
  if (plot_file && std::ranges::all_of(plan.methods, &motion::Method::exact)) {
    throw InvalidArgument("--plot", "the exact method alone has no steps to plot");
  }
  plan.progress = progress_lines("study");
  const motion::FreeBody body = scene::free_body(scene);
  const study::Study result = study::run_study(body, plan);
  system::Output output(file);  // write both it and the plot, or neither
  output.write(report(file.format().name, result, options.scene.name_of(scene)));
  if (plot_file) plot::draw_plot(*plot_file, plot::study_plot(result));
  output.finish();
  return verdict(result, bounds);
}

void add_options(CLI::App& command, StudyOptions& options) {
  options.scene.add_motion_options();
  command.add_option("--methods", options.methods, "methods to compare")
      ->type_name("A,B,...")
      ->default_str("all, or the value of --method")
      ->group(heading(OptionGroup::motion));
  command.add_option("--steps", options.steps, "step sizes, s")
      ->type_name("H1,H2,...")
      ->default_str("successive halvings")
      ->group(heading(OptionGroup::motion));
  command.add_option("--tolerances", options.tolerances, "tolerances of the adaptive methods")
      ->type_name("T1,T2,...")
      ->default_str("1e-4 to 1e-12")
      ->group(heading(OptionGroup::motion));
  command
      .add_option("--max-error", options.max_error,
                  "exit 1 if the error of X at the end of any run exceeds this")
      ->type_name("E")
      ->group(heading(OptionGroup::bounds));
  command
      .add_option("--max-energy-drift", options.max_energy_drift,
                  "exit 1 if the relative energy drift of any run exceeds this")
      ->type_name("E")
      ->group(heading(OptionGroup::bounds));
  command
      .add_option("--max-flip-error", options.max_flip_error,
                  "exit 1 if any run misses a flip, or its time by more than this, s")
      ->type_name("S")
      ->group(heading(OptionGroup::bounds));
  command
      .add_option("--plot", options.plot,
                  "plot order, work-precision and energy drift: .svg, .pdf or .png")
      ->type_name("FILE")
      ->group(heading(OptionGroup::output));
}

}  // namespace

void add_study(CLI::App& app, ExitCode& code) {
  CLI::App* command = app.add_subcommand(
      "study", "Compare methods with the exact solution: order, error, drift, flip times, cost");
  command->footer(std::string(about_defaults) +
                  "Example: twrench study dzhanibekov --methods rk4,rkmk4 --duration 20\n"
                  "Exit code 1 if a --max-... bound is exceeded.");
  const auto options = std::make_shared<StudyOptions>(*command);
  add_options(*command, *options);
  command->callback([options, &code] { code = run_study(*options); });
}

}  // namespace twrench::app
