#include "interchange/export.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/commands/commands.h"
#include "app/options/arguments.h"
#include "app/options/command_line.h"
#include "app/options/scene_options.h"
#include "app/terminal/message.h"
#include "scene/limits.h"
#include "system/output.h"

namespace twrench::app {
namespace {

struct ExportOptions {
  explicit ExportOptions(CLI::App& command)
      : scene(command), output(command, system::exported_motion, OutputOptions::Otherwise::none) {
    scene.add_motion_options();
    scene.add_recording_options();
    scene.add_look_options();
  }

  SceneOptions scene;
  OutputOptions output;
  std::string max_angle = "1e-4";
  std::string speed;
  std::string epoch = "2026-01-01T00:00:00";
};

interchange::ExportOptions parsed(const ExportOptions& options) {
  interchange::ExportOptions values;
  values.max_angle = parse_number(options.max_angle, "--max-angle", interchange::max_angle_limit);
  if (!options.speed.empty()) {
    values.speed = parse_number(options.speed, "--speed", scene::limits::speed);
  }
  values.epoch = options.epoch;
  return values;
}

void export_motion(const ExportOptions& options) {
  system::FileList files = options.output.files();
  options.scene.add_inputs(files);
  const system::OutputFile file = options.output.add_to(files);
  const interchange::ExportOptions values = parsed(options);
  const scene::Scene scene = options.scene.scene();
  system::Output output(file);
  const std::vector<std::string> notes =
      interchange::export_format(file.format()).write(values, scene, [&](std::string_view text) {
        output.write(text);
      });
  output.finish();
  for (const std::string& note : notes) warn(note);
}

std::string export_footer() {
  std::string text = about_defaults;
  text +=
      "Files .glb, .py and .aem have the exact motion, whatever the method. Rows are 1/fps apart\n"
      "or, without --fps, as near to each other as the motion needs.\n"
      "Formats, by the ending of the file:\n";
  for (const interchange::ExportFormat& format : interchange::export_formats()) {
    text += fmt::format("  .{:<5} {}\n", format.name, format.what);
  }
  return text + "Example: twrench export -o flip.glb --max-angle 1e-5";
}

void add_export_options(CLI::App& command, ExportOptions& options) {
  command
      .add_option("--max-angle", options.max_angle,
                  "bound for the angle between the animation of .glb or .py, at any instant, and "
                  "the exact motion, rad")
      ->type_name("RAD")
      ->capture_default_str()
      ->group(heading(OptionGroup::film));
  command.remove_option(command.get_option("--speed"));  // which is the film's
  command
      .add_option("--speed", options.speed,
                  "seconds of motion per second of the animation of .glb or .py")
      ->type_name("F")
      ->default_str("1; that of the film if it is below 0.01 or above 100")
      ->group(heading(OptionGroup::film));
  command.add_option("--epoch", options.epoch, "date and time of t = 0 in .aem, TAI")
      ->type_name("DATE")
      ->capture_default_str()
      ->group(heading(OptionGroup::film));
}

}  // namespace

void add_export(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "export", "Write the motion for other programs: glTF, Blender, CCSDS, CSV, JSON, NumPy");
  command->footer(export_footer());
  const auto options = std::make_shared<ExportOptions>(*command);
  add_export_options(*command, *options);
  command->callback([options] { export_motion(*options); });
}

}  // namespace twrench::app
