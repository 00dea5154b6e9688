#include <fmt/format.h>
#include <twrench/base/error.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>

#include "app/commands/commands.h"
#include "app/options/arguments.h"
#include "app/options/scene_options.h"
#include "app/reports/trajectory_output.h"
#include "app/terminal/message.h"
#include "app/terminal/version.h"
#include "interchange/aem.h"
#include "interchange/gltf_scene.h"
#include "interchange/key_times.h"
#include "scene/limits.h"

namespace twrench::app {
namespace {

struct ExportOptions {
  explicit ExportOptions(CLI::App& command) : scene(command) {
    scene.add_motion_options();
    scene.add_look_options();
  }

  SceneOptions scene;
  std::string output;
  std::string format;
  std::string max_angle = "1e-4";
  std::string speed;
  std::string epoch = "2026-01-01T00:00:00";
};

std::string generator() { return std::string("twrench ") + version; }

/// The keys are as exact as was asked for, but a player may not be.
void warn_of_coarse_clocks(const scene::Scene& scene,
                           const interchange::AnimationOptions& animation) {
  const auto end = static_cast<float>(scene.motion.duration / animation.speed);
  const double spacing = std::nextafter(end, std::numeric_limits<float>::infinity()) - end;
  const double angle = scene.motion.omega.norm() * animation.speed * spacing / 2;
  if (angle <= animation.max_angle) return;
  warn(
      fmt::format("a player that keeps the time as a float32 number is off by up to {:.2g} rad at "
                  "{:.6g} s, where these are {:.2g} s apart",
                  angle, end, spacing));
}

/// Returns the seconds of motion per second of the animation. Without the option they are the same,
/// unless the motion is too fast or too slow to be watched.
double animation_speed(const ExportOptions& options, const scene::Scene& scene) {
  if (!options.speed.empty()) return parse_number(options.speed, "--speed", scene::limits::speed);
  constexpr double slowest = 0.01, fastest = 100;  // of films that show about as much as real time
  const double speed = scene.film.speed;
  return speed >= slowest && speed <= fastest ? 1 : speed;
}

void write_gltf(const ExportOptions& options, const scene::Scene& scene, Output& output) {
  constexpr scene::limits::Limit max_angle{interchange::least_max_angle, scene::limits::huge,
                                           "the limit of glTF's float32 numbers"};
  const interchange::AnimationOptions animation{
      .max_angle = parse_number(options.max_angle, "--max-angle", max_angle),
      .speed = animation_speed(options, scene)};
  interchange::gltf_scene(scene, animation, generator()).write_glb([&](std::string_view piece) {
    output.write(piece);
  });
  warn_of_coarse_clocks(scene, animation);
}

void write_attitude_ephemeris(const ExportOptions& options, const scene::Scene& scene,
                              Output& output) {
  const RegularTimes times(scene);
  interchange::write_aem(scene, interchange::parse_epoch(options.epoch, "--epoch"), generator(),
                         times.size(), times, [&](std::string_view piece) { output.write(piece); });
}

/// A format, which is the ending of its files.
struct ExportFormat {
  const char* name;
  const char* what;
  void (*write)(const ExportOptions&, const scene::Scene&, Output&);
};

const std::array<ExportFormat, 4> export_formats{
    {{"glb", "glTF 2.0, an animated model", write_gltf},
     {"aem", "CCSDS attitude ephemeris message", write_attitude_ephemeris},
     {"csv", "as simulate writes it",
      [](const ExportOptions&, const scene::Scene& scene, Output& output) {
        write_trajectory(output, scene, "csv", {});
      }},
     {"json", "as simulate writes it",
      [](const ExportOptions&, const scene::Scene& scene, Output& output) {
        write_trajectory(output, scene, "json", {});
      }}}};

const ExportFormat& format_of(const ExportOptions& options) {
  const std::string ending = std::filesystem::path(options.output).extension().string();
  for (const ExportFormat& format : export_formats) {
    if (options.format == format.name) return format;
    if (options.format.empty() && ending == std::string(".") + format.name) return format;
  }
  if (options.output == "-") {
    throw InvalidArgument("--format", "is needed for standard output, which has no ending",
                          "give glb, aem, csv or json");
  }
  throw InvalidArgument(fmt::format("export {}", options.output),
                        "its name must end in .glb, .aem, .csv or .json",
                        "choose another name, or the format: --format glb, aem, csv or json");
}

void export_motion(const ExportOptions& options) {
  options.scene.require_not_input(options.output);
  const ExportFormat& format = format_of(options);
  const scene::Scene scene = options.scene.scene();
  Output output(options.output);
  format.write(options, scene, output);
  output.finish();
}

std::string export_footer() {
  std::string text = about_defaults;
  text +=
      "Files .glb and .aem have the exact motion, whatever the method. Rows are 1/fps apart or,\n"
      "without --fps, as near to each other as the motion needs.\n"
      "Formats, by the ending of the file:\n";
  for (const ExportFormat& format : export_formats) {
    text += fmt::format("  .{:<5} {}\n", format.name, format.what);
  }
  return text + "Example: twrench export -o flip.glb --max-angle 1e-5";
}

void add_export_options(CLI::App& command, ExportOptions& options) {
  command.add_option("-o,--output", options.output, "output file, or - for standard output")
      ->required()
      ->type_name("FILE");
  command.add_option("--format", options.format, "output format: glb, aem, csv or json")
      ->check(one_of("--format", {"glb", "aem", "csv", "json"}))
      ->type_name("FORMAT")
      ->default_str("the ending of the file");
  command
      .add_option("--max-angle", options.max_angle,
                  "bound for the angle between the animation of .glb, at any instant, and the "
                  "exact motion, rad")
      ->type_name("RAD")
      ->capture_default_str();
  command.remove_option(command.get_option("--speed"));  // that of the film
  command
      .add_option("--speed", options.speed, "seconds of motion per second of the animation of .glb")
      ->type_name("F")
      ->default_str("1; that of the film if it is below 0.01 or above 100");
  command.add_option("--epoch", options.epoch, "date and time of t = 0 in .aem, TAI")
      ->type_name("DATE")
      ->capture_default_str();
}

}  // namespace

void add_export(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("export", "Write the motion for other programs: glTF, CCSDS, CSV, JSON");
  command->footer(export_footer());
  const auto options = std::make_shared<ExportOptions>(*command);
  add_export_options(*command, *options);
  command->callback([options] { export_motion(*options); });
}

}  // namespace twrench::app
