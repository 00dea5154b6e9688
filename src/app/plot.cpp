#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "app/commands.h"
#include "app/scene_options.h"
#include "figure/attitude_figure.h"
#include "motion/exact.h"
#include "motion/trajectory.h"

namespace twrench {
namespace {

struct Options {
  explicit Options(CLI::App& command) : scenes(command, SceneOptions::Count::several) {
    scenes.add_motion_options();
  }

  SceneOptions scenes;
  std::string output;
  bool overlay = false;
};

/// Enough times for smooth curves, but no more than a plot can show.
std::vector<double> plot_times(const Scene& scene) {
  constexpr double a_turn = 60.0, fewest = 600.0, most = 20'000.0;
  const double turns = scene.motion.duration * scene.motion.omega.norm() / (2 * std::numbers::pi);
  const double count = std::clamp(std::ceil(a_turn * turns), fewest, most);
  std::vector<double> times;
  for (int i = 0; i <= static_cast<int>(count); ++i) {
    times.push_back(scene.motion.duration * i / count);
  }
  return times;
}

AttitudeCurve curve_of(const Scene& scene) {
  const FreeBody body(mass_properties(scene.body).inertia, scene.motion.omega);
  const Method& method = find_method(scene.motion.method);
  AttitudeCurve curve;
  curve.title = scene.title.empty() ? scene.name : scene.title;
  curve.samples = trajectory(body, method, scene.motion.control, plot_times(scene)).samples;
  const ExactMotion motion(body);
  const auto flips = motion.flips();
  if (flips && flips->swing > std::numbers::pi / 2) {
    curve.flips = motion.flip_times(scene.motion.duration);
  }
  return curve;
}

void plot(const Options& options) {
  options.scenes.require_not_input(options.output);
  require_gnuplot(options.output);
  std::vector<AttitudeCurve> curves;
  for (const Scene& scene : options.scenes.scenes()) curves.push_back(curve_of(scene));
  draw_figure(options.output, options.overlay ? column_panels(curves) : nine_panels(curves));
}

}  // namespace

void add_plot(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("plot", "Plot the nine components of X against time and mark the flips");
  command->footer(std::string(about_defaults) +
                  "Example: twrench plot dzhanibekov stable-y stable-z -o components.svg");
  const auto options = std::make_shared<Options>(*command);
  command->add_option("-o,--output", options->output, "plot file: .svg, .pdf or .png")
      ->required()
      ->type_name("FILE");
  command->add_flag("--overlay", options->overlay,
                    "one panel per column of X, one row of panels per scene");
  command->callback([options] { plot(*options); });
}

}  // namespace twrench
