#include <twrench/motion/exact.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/commands/commands.h"
#include "app/options/arguments.h"
#include "app/options/command_line.h"
#include "app/options/scene_options.h"
#include "app/terminal/message.h"
#include "interchange/samples.h"
#include "scene/limits.h"
#include "system/output.h"

namespace twrench::app {
namespace {

struct SimulateOptions {
  explicit SimulateOptions(CLI::App& command)
      : scene(command), output(command, system::motion_output) {
    scene.add_motion_options();
    scene.add_recording_options();
  }

  SceneOptions scene;
  OutputOptions output;
  std::string times;
};

std::vector<double> times_asked_for(const SimulateOptions& options) {
  std::vector<double> times = parse_numbers(options.times, "--times");
  for (const double t : times)
    scene::limits::check({-scene::limits::duration.high, scene::limits::duration.high}, "--times",
                         t);
  return times;
}

/// For a method that takes long, where the closed form takes no steps.
std::string advice_on(const scene::Scene& scene) {
  const bool has_closed_form = motion::ExactMotion::covers(scene::free_body(scene));
  return has_closed_form ? "; --method exact takes no steps" : "";
}

void simulate(const SimulateOptions& options) {
  system::FileList files = options.output.files();
  options.scene.add_inputs(files);
  const system::OutputFile file = options.output.add_to(files);
  const scene::Scene scene = options.scene.scene();
  const std::vector<double> times =
      options.times.empty() ? std::vector<double>() : times_asked_for(options);
  system::Output output(file);
  const std::string note = interchange::write_trajectory(
      [&](std::string_view text) { output.write(text); }, scene, std::string(file.format().name),
      times, progress_lines("simulate", advice_on(scene)));
  output.finish();
  if (!note.empty()) warn(note);
}

}  // namespace

void add_simulate(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "simulate", "Compute the trajectory and write it as CSV, JSON or NumPy arrays");
  command->footer(std::string(about_defaults) +
                  "Example: twrench simulate stable-y --method rk4 --times 1,10,100");
  const auto options = std::make_shared<SimulateOptions>(*command);
  command->add_option("--times", options->times, "sample at exactly these times, s")
      ->type_name("T1,T2,...")
      ->default_str("every 1/fps")
      ->group(heading(OptionGroup::motion));
  command->callback([options] { simulate(*options); });
}

}  // namespace twrench::app
