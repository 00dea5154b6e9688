// The commands that print lists.
#include <fmt/format.h>
#include <twrench/base/error.h>
#include <twrench/motion/method.h>

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "app/commands/commands.h"
#include "scene/motion_summary.h"
#include "scene/scene.h"
#include "system/output.h"

namespace twrench::app {
namespace {

std::string description_of_scene(const std::string& name) {
  try {
    const scene::Scene scene = scene::load_scene(name);
    return fmt::format("{}; {}", scene.title, motion_summary(scene));
  } catch (const Error& error) {
    return fmt::format("invalid: {}", error.what());
  }
}

}  // namespace

std::string scene_list(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) {
    text += fmt::format("{:<13} {}\n", name, description_of_scene(name));
  }
  return text;
}

void add_methods(CLI::App& app) {
  CLI::App* command = app.add_subcommand("methods", "List the integration methods");
  command->footer("Example: twrench methods");
  command->callback([] {
    std::string text;
    for (const motion::Method& m : motion::methods()) {
      const std::string order = m.exact() ? "exact  " : fmt::format("order {}", m.order.value());
      text += fmt::format("{:<19}{}  {}; {}\n", m.name, order, m.summary, m.source);
    }
    system::write_output(text);
  });
}

void add_scenes(CLI::App& app) {
  CLI::App* command = app.add_subcommand("scenes", "List the built-in scenes");
  command->footer("Example: twrench scenes");
  command->callback([] { system::write_output(scene_list(scene::builtin_scene_names())); });
}

}  // namespace twrench::app
