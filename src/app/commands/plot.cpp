#include <fmt/format.h>
#include <twrench/motion/exact.h>
#include <twrench/motion/trajectory.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "app/commands/commands.h"
#include "app/options/scene_options.h"
#include "plot/attitude_plot.h"

namespace twrench::app {
namespace {

struct PlotOptions {
  explicit PlotOptions(CLI::App& command) : scenes(command, SceneOptions::Count::several) {
    scenes.add_motion_options();
  }

  SceneOptions scenes;
  std::string output;
  bool overlay = false;
};

/// Enough times for smooth curves, but no more than a plot can show.
std::vector<double> plot_times(const scene::Scene& scene) {
  constexpr double a_turn = 60.0, fewest = 600.0, most = 20'000.0;
  const double turns = scene.motion.duration * scene.motion.omega.norm() / (2 * std::numbers::pi);
  const double count = std::clamp(std::ceil(a_turn * turns), fewest, most);
  std::vector<double> times;
  for (int i = 0; i <= static_cast<int>(count); ++i) {
    times.push_back(scene.motion.duration * i / count);
  }
  return times;
}

plot::AttitudeCurve curve_of(const scene::Scene& scene) {
  const motion::FreeBody body(scene::mass_properties(scene.body).inertia, scene.motion.omega);
  const motion::Method& method = motion::find_method(scene.motion.method);
  plot::AttitudeCurve curve;
  curve.title = scene.shown_title();
  curve.samples = motion::integrate(body, method, scene.motion.control, plot_times(scene)).samples;
  const motion::ExactMotion motion(body);
  const auto flips = motion.flips();
  if (flips && flips->turns_over()) {
    curve.flips = motion.flip_times(scene.motion.duration);
  }
  return curve;
}

void plot(const PlotOptions& options) {
  options.scenes.require_not_input(options.output);
  plot::require_gnuplot(options.output);
  std::vector<plot::AttitudeCurve> curves;
  for (const scene::Scene& scene : options.scenes.scenes()) curves.push_back(curve_of(scene));
  plot::draw_plot(options.output,
                  options.overlay ? plot::column_panels(curves) : plot::nine_panels(curves));
}

}  // namespace

void add_plot(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("plot", "Plot the nine components of X against time and mark the flips");
  command->footer(std::string(about_defaults) +
                  "Example: twrench plot dzhanibekov stable-y stable-z -o components.svg");
  const auto options = std::make_shared<PlotOptions>(*command);
  command->add_option("-o,--output", options->output, "plot file: .svg, .pdf or .png")
      ->required()
      ->type_name("FILE");
  command->add_flag("--overlay", options->overlay,
                    "one panel per column of X, one row of panels per scene");
  command->callback([options] { plot(*options); });
}

}  // namespace twrench::app
