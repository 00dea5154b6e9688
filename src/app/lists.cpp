// The commands that print lists.
#include <fmt/format.h>
#include <twrench/motion/method.h>

#include <CLI/CLI.hpp>

#include "app/commands.h"
#include "app/output.h"
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

/// The title of a scene and what a small tilt of its body does.
std::string summary(const scene::Scene& scene) {
  const motion::FreeBody body(scene::mass_properties(scene.body).inertia, scene.motion.omega);
  const motion::Tilt tilt(body);
  return fmt::format("{}; {}", scene.title,
                     scene::prediction(body.principal(), tilt.axis(), tilt.steady_rate()));
}

}  // namespace

void add_scenes(CLI::App& app) {
  CLI::App* command = app.add_subcommand("scenes", "List the built-in scenes");
  command->footer("Example: twrench scenes");
  command->callback([] {
    std::string text;
    for (const std::string& name : scene::builtin_scene_names()) {
      text += fmt::format("{:<12} {}\n", name, summary(scene::load_scene(name)));
    }
    write_output("-", text);
  });
}

}  // namespace twrench::app
