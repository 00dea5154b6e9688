#include "app/options/report_commands.h"

#include <CLI/CLI.hpp>

#include "app/options/arguments.h"
#include "report/command_lines.h"
#include "system/program.h"

namespace twrench::app {
std::string report_command_line(const CLI::App& command, const SceneOptions& scenes,
                                const std::string& output, bool is_static) {
  std::vector<std::string> words{"twrench", "report"};
  if (command.count("SCENE") > 0) {
    for (const std::string& source : scenes.sources()) words.push_back(report::argument_of(source));
  }
  const std::vector<std::string> mesh = scenes.mesh_options().given();
  words.insert(words.end(), mesh.begin(), mesh.end());
  const auto others =
      given_options(command, {"--omega", "--attitude", "--wheel", "--energy-loss-time", "--inertia",
                              "--method", "--step", "--tolerance", "--duration", "--fps", "--speed",
                              "--language", "--author", "--date"});
  words.insert(words.end(), others.begin(), others.end());
  if (is_static) words.emplace_back("--static");
  words.insert(words.end(), {"-o", report::argument_of(output)});
  return system::shell_command(words);
}

report::Commands commands_of(const scene::Scene& scene, const std::vector<std::string>& source,
                             const CLI::App& command) {
  return report::commands_of(scene, source, given_options(command, {"--inertia"}),
                             given_options(command, {"--omega", "--attitude", "--wheel",
                                                     "--energy-loss-time", "--duration"}));
}

}  // namespace twrench::app
