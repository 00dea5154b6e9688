// The commands that print lists.
#include <fmt/format.h>
#include <twrench/motion/exact.h>
#include <twrench/motion/method.h>

#include <CLI/CLI.hpp>

#include "app/commands/commands.h"
#include "app/terminal/output.h"
#include "scene/prediction.h"
#include "scene/scene.h"

namespace twrench::app {

void add_methods(CLI::App& app) {
  CLI::App* command = app.add_subcommand("methods", "List the integration methods");
  command->footer("Example: twrench methods");
  command->callback([] {
    std::string text;
    for (const motion::Method& m : motion::methods()) {
      const std::string order = m.exact() ? "exact  " : fmt::format("order {}", m.order.value());
      text += fmt::format("{:<19}{}  {}; {}\n", m.name, order, m.summary, m.source);
    }
    write_output("-", text);
  });
}

namespace {

/// "1 : 1.36 : 2.18", the principal moments as multiples of the least.
std::string ratio_of_moments(const Eigen::Vector3d& moments) {
  return fmt::format("1 : {:.3g} : {:.3g}", moments[1] / moments[0], moments[2] / moments[0]);
}

/// How often the body turns over, by the exact motion.
std::string flips(const motion::FreeBody& body) {
  const auto flips = motion::ExactMotion(body).flips();
  if (!flips || !flips->turns_over()) return "does not flip";
  constexpr double day = 86400.0;
  return flips->interval < day ? fmt::format("flips every {:.3g} s", flips->interval)
                               : fmt::format("flips every {:.3g} d", flips->interval / day);
}

/// The title of a scene, what a small tilt of its body does, the ratio of its moments, and how
/// often it flips.
std::string summary(const scene::Scene& scene) {
  const motion::FreeBody body(scene::mass_properties(scene.body).inertia, scene.motion.omega);
  const motion::Tilt tilt(body);
  return fmt::format("{}; {}; moments {}; {}", scene.title,
                     scene::prediction(body.principal(), tilt.axis(), tilt.steady_rate()),
                     ratio_of_moments(body.principal().moments), flips(body));
}

}  // namespace

void add_scenes(CLI::App& app) {
  CLI::App* command = app.add_subcommand("scenes", "List the built-in scenes");
  command->footer("Example: twrench scenes");
  command->callback([] {
    std::string text;
    for (const std::string& name : scene::builtin_scene_names()) {
      text += fmt::format("{:<13} {}\n", name, summary(scene::load_scene(name)));
    }
    write_output("-", text);
  });
}

}  // namespace twrench::app
