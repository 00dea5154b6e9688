#include "app/commands.h"

#include <algorithm>

#include "base/nearest.h"

namespace twrench {

void add_commands(CLI::App& app, ExitCode& code) {
  add_render(app);
  add_simulate(app);
  add_plot(app);
  add_inertia(app);
  add_study(app, code);
  add_encode(app);
  add_compare(app, code);
  add_doctor(app, code);
  add_methods(app);
  add_scenes(app);
}

void require_known_command(const CLI::App& app, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  if (word.starts_with("-") || std::ranges::find(names, word) != names.end()) return;
  throw unknown_name("command", word, names);
}

}  // namespace twrench
