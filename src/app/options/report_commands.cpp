#include "app/options/report_commands.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>

#include "app/options/arguments.h"
#include "system/program.h"

namespace twrench::app {
namespace {

std::string line_of(std::vector<std::string> words, const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return system::shell_command(words);
}

}  // namespace

std::string argument_of(const std::string& name) {
  return name.starts_with('-') && name != "-" ? "./" + name : name;
}

std::string report_command_line(const CLI::App& command, const SceneOptions& scenes,
                                const std::string& output, bool is_static) {
  std::vector<std::string> words{"twrench", "report"};
  if (command.count("SCENE") > 0) {
    for (const std::string& source : scenes.sources()) words.push_back(argument_of(source));
  }
  const std::vector<std::string> mesh = scenes.mesh_options().given();
  words.insert(words.end(), mesh.begin(), mesh.end());
  const auto others =
      given_options(command, {"--omega", "--inertia", "--method", "--step", "--tolerance",
                              "--duration", "--fps", "--speed", "--author", "--date"});
  words.insert(words.end(), others.begin(), others.end());
  if (is_static) words.emplace_back("--static");
  return line_of(std::move(words), {"-o", argument_of(output)});
}

report::Commands commands_of(const scene::Scene& scene, const std::vector<std::string>& source,
                             const CLI::App& command) {
  const std::string body = line_of(source, given_options(command, {"--inertia"}));
  const std::string motion =
      line_of(source, given_options(command, {"--inertia", "--omega", "--duration"}));
  const std::string study = "twrench study " + motion, plot = "twrench plot " + motion;
  const std::string file = line_of({"-o"}, {"components-" + scene.name + ".svg"});
  const motion::StepControl& control = scene.motion.control;
  return {.inertia = "twrench inertia " + body,
          .start = "twrench simulate " + motion + " --times 0",
          .constants = study + " --methods exact",
          .own_method = fmt::format("{} --method {} --step {} --tolerance {}", study,
                                    scene.motion.method, control.step, control.tolerance),
          .study = study,
          .diagrams = study + " --plot methods.svg",
          .study_of =
              [study](const std::vector<std::string>& methods) {
                return fmt::format("{} --methods {}", study, fmt::join(methods, ","));
              },
          .solution =
              [study](const std::string& method, double step) {
                return fmt::format("{} --method {} --step {}", study, method, step);
              },
          .components = plot + " --method exact " + file,
          .components_of =
              [plot, file](const std::string& method, double step) {
                return fmt::format("{} --method {} --step {} {}", plot, method, step, file);
              }};
}

report::TaskCommands task_commands() {
  return {.exponentials =
              [](const std::string& omega, double step, const std::vector<double>& times) {
                return fmt::format(
                    "twrench simulate sphere --omega {} --method lie-euler --step {} --times {}",
                    omega, step, fmt::join(times, ","));
              },
          .sphere =
              [](const std::vector<double>& times) {
                return fmt::format("twrench simulate sphere --method exact --times {}",
                                   fmt::join(times, ","));
              },
          .sphere_study =
              [](const std::vector<std::string>& methods, const std::vector<double>& steps,
                 double duration) {
                return fmt::format("twrench study sphere --methods {} --steps {} --duration {}",
                                   fmt::join(methods, ","), fmt::join(steps, ","), duration);
              }};
}

}  // namespace twrench::app
