// twrench_manual FOLDER SCENE_FILE DATE: writes the manual pages and the shell completions of
// twrench to FOLDER, from the definitions with which the program parses its command line.
#include <cstdio>
#include <filesystem>
#include <string>

#include "app/commands/commands.h"
#include "app/terminal/version.h"
#include "manual/manual.h"
#include "system/file.h"

namespace twrench::manual {
namespace {

void write_all(const std::filesystem::path& folder, const std::string& example,
               const Release& release) {
  const auto [program, commands] = app::program_model();
  std::filesystem::create_directories(folder);
  const auto write = [&](const std::string& name, const std::string& text) {
    system::write_file_atomically(folder / name, text);
  };
  write("twrench.1", program_page(program, commands, release));
  for (const app::Command& command : commands) {
    write("twrench-" + command.name + ".1", command_page(command, release));
  }
  write("twrench-scene.5", scene_page(example, release));
  write("twrench.bash", bash_completion(program, commands));
  write("_twrench", zsh_completion(program, commands));
  write("twrench.fish", fish_completion(program, commands));
}

}  // namespace
}  // namespace twrench::manual

int main(int argc, char** argv) try {
  using namespace twrench;
  if (argc != 4) {
    static_cast<void>(std::fputs("usage: twrench_manual FOLDER SCENE_FILE DATE\n", stderr));
    return 2;
  }
  constexpr std::size_t largest = 1 << 20;
  const auto example = system::read_file(argv[2], largest);
  manual::write_all(argv[1], {example.begin(), example.end()}, {app::version, argv[3]});
  return 0;
} catch (const std::exception& error) {
  static_cast<void>(std::fprintf(stderr, "twrench_manual: error: %s\n", error.what()));
  return 5;
}
