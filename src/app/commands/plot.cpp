#include <CLI/CLI.hpp>
#include <memory>

#include "app/commands/commands.h"
#include "app/options/option_group.h"
#include "app/options/scene_options.h"
#include "plot/attitude_plot.h"
#include "report/attitude_curve.h"

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

void plot(const PlotOptions& options) {
  options.scenes.require_not_input(options.output);
  plot::require_gnuplot(options.output);
  std::vector<plot::AttitudeCurve> curves;
  for (const scene::Scene& scene : options.scenes.scenes()) {
    curves.push_back(report::attitude_curve(scene));
  }
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
      ->type_name("FILE")
      ->group(heading(OptionGroup::output));
  command
      ->add_flag("--overlay", options->overlay,
                 "one panel per column of X, one row of panels per scene")
      ->group(heading(OptionGroup::overlays));
  command->callback([options] { plot(*options); });
}

}  // namespace twrench::app
