#include <CLI/CLI.hpp>
#include <memory>
#include <utility>

#include "app/commands/commands.h"
#include "app/options/arguments.h"
#include "app/options/command_line.h"
#include "app/options/scene_options.h"
#include "app/terminal/message.h"
#include "motion/visible_error.h"
#include "plot/plots.h"
#include "report/solution.h"

namespace twrench::app {
namespace {

struct PlotOptions {
  explicit PlotOptions(CLI::App& command)
      : scenes(command, SceneOptions::Count::several),
        output(command, system::plot_output, OutputOptions::Otherwise::none) {
    scenes.add_motion_options();
    scenes.add_recording_options();
  }

  SceneOptions scenes;
  OutputOptions output;
  bool overlay = false;
};

void plot(const PlotOptions& options) {
  system::FileList files = options.output.files();
  options.scenes.add_inputs(files);
  const system::OutputFile file = options.output.add_to(files);
  plot::require_gnuplot(file.format());
  std::vector<plot::AttitudeCurve> curves;
  for (const scene::Scene& scene : options.scenes.scenes()) {
    for (plot::AttitudeCurve& curve : report::shown_curves(scene)) {
      curves.push_back(std::move(curve));
    }
    if (scene.motion.recording) continue;
    const std::string error =
        motion::visible_error(scene::free_body(scene), motion::find_method(scene.motion.method),
                              curves.back().samples.back());
    if (!error.empty()) warn(error);
  }
  plot::draw_plot(file, options.overlay ? plot::column_panels(curves) : plot::nine_panels(curves));
}

}  // namespace

void add_plot(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("plot", "Plot the nine components of X against time and mark the flips");
  command->footer(std::string(about_defaults) +
                  "Example: twrench plot dzhanibekov stable-y stable-z -o components.svg");
  const auto options = std::make_shared<PlotOptions>(*command);
  command
      ->add_flag("--overlay", options->overlay,
                 "one panel per column of X, one row of panels per scene")
      ->group(heading(OptionGroup::overlays));
  command->callback([options] { plot(*options); });
}

}  // namespace twrench::app
