#include "report/command_lines.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "motion/reference_motion.h"
#include "system/program.h"

namespace twrench::report {

std::string argument_of(const std::string& name) {
  return name.starts_with('-') && name != "-" ? "./" + name : name;
}

Commands commands_of(const scene::Scene& scene, const std::vector<std::string>& source,
                     const std::vector<std::string>& body_options,
                     const std::vector<std::string>& motion_options) {
  std::vector<std::string> words = source;
  words.insert(words.end(), body_options.begin(), body_options.end());
  const std::string body = system::shell_command(words);
  words.insert(words.end(), motion_options.begin(), motion_options.end());
  const std::string motion = system::shell_command(words);
  const std::string study = "twrench study " + motion, plot = "twrench plot " + motion;
  const motion::FreeBody free_body = scene::free_body(scene);
  const motion::Method& reference = motion::reference_method(free_body);
  const std::vector<std::string> output{"-o", "components-" + scene.name + ".svg"};
  const std::string file = system::shell_command(output);
  const motion::StepControl& control = scene.motion.control;
  return {.inertia = "twrench inertia " + body,
          .start = "twrench simulate " + motion + " --times 0",
          .constants = fmt::format("{} --methods {}", study, reference.name),
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
          .components = fmt::format("{} --method {} {}", plot, reference.name, file),
          .components_of =
              [plot, file](const std::string& method, double step) {
                return fmt::format("{} --method {} --step {} {}", plot, method, step, file);
              }};
}

TaskCommands task_commands() {
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

}  // namespace twrench::report
