#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/enumeration.h"
#include "manual/manual.h"
#include "manual/program.h"
#include "run_command.h"
#include "scene/scene.h"
#include "scratch_folder.h"

namespace twrench::manual {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(Completions, HaveEachOptionOfEachCommand) {
  const std::string bash = written("twrench.bash"), zsh = written("_twrench"),
                    fish = written("twrench.fish");
  for (const Command& command : all_commands()) {
    const std::string of_fish = "__fish_seen_subcommand_from " + command.name + "'";
    const std::size_t begin = zsh.find("    " + command.name + ")\n");
    ASSERT_NE(begin, std::string::npos) << command.name;
    const std::string of_zsh = zsh.substr(begin, zsh.find(";;", begin) - begin);
    for (const Option& option : command.options) {
      std::string names;
      for (const std::string& name : option.names) {
        EXPECT_THAT(bash, testing::ContainsRegex("    " + command.name +
                                                 "\\) _twrench_words '[^']*" + name))
            << command.name;
        EXPECT_THAT(of_zsh, testing::ContainsRegex(name + "=?\\[")) << command.name;
        names += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
      }
      EXPECT_THAT(fish, HasSubstr(of_fish + names)) << command.name;
    }
  }
}

/// The completions that bash offers for the last of the words.
std::string offered(const std::string& words) {
  const ScratchFolder folder;
  system::write_file_atomically(folder / "mine.toml", "");
  system::write_file_atomically(folder / "notes.txt", "");
  system::write_file_atomically(folder / "model.stl", "");
  system::write_file_atomically(
      folder / "ask.sh", "compopt() { :; }\nsource " TWRENCH_MANUAL "/twrench.bash\nCOMP_WORDS=(" +
                             words +
                             ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_twrench\n"
                             "echo \"${COMPREPLY[*]}\"\n");
  run_command("cd '" + folder.path().string() + "' && bash ask.sh >offered 2>&1");
  const auto text = system::read_file(folder / "offered", 10'000);
  return {text.begin(), text.end()};
}

/// The names on a line, separated by spaces: "studio paper space".
std::string spaced(const std::vector<std::string>& names) {
  std::string line;
  for (const std::string& name : names) line += (line.empty() ? "" : " ") + name;
  return line + "\n";
}

TEST(Completions, OfBashOfferWhatFits) {
  EXPECT_EQ(offered("twrench re"), "render report\n");
  EXPECT_EQ(offered("twrench render --th"), "--theme\n");
  EXPECT_EQ(offered("twrench render --theme \"\""), spaced(enumerator_names<scene::Theme>()));
  EXPECT_EQ(offered("twrench render --theme = p"), "paper\n");
  EXPECT_EQ(offered("twrench render --show floor,tr"), "floor,trail\n");
  EXPECT_EQ(offered("twrench render m"), "mine.toml model.stl\n");
  EXPECT_EQ(offered("twrench inertia m"), "mine.toml model.stl\n");
  EXPECT_EQ(offered("twrench plot dzh"), "dzhanibekov\n");
  EXPECT_EQ(offered("twrench study --format \"\""), "text csv json\n");
  EXPECT_EQ(offered("twrench simulate --format \"\""), "csv json npz\n");
  EXPECT_EQ(offered("twrench inertia --format \"\""), "text json junit\n");
  EXPECT_EQ(offered("twrench doctor --format \"\""), "text json\n");
  EXPECT_EQ(offered("twrench render --backend \"\""), "auto osmesa egl\n");
  EXPECT_EQ(offered("twrench cases gaz"), "gazebo-box\n");
  EXPECT_EQ(offered("twrench check run.csv --case gaz"), "gazebo-box\n");
  EXPECT_EQ(offered("twrench compare n"), "notes.txt\n");
  EXPECT_EQ(offered("twrench render --step 0"), "\n");
  EXPECT_EQ(offered("twrench unknown x"), "\n");
}

TEST(Completions, OfEachShellOfferMeshesToEveryCommandThatTakesAScene) {
  const std::string endings = "toml stl obj ply gltf glb dae 3mf urdf sdf xml",
                    zsh = "toml\\|stl\\|obj\\|ply\\|gltf\\|glb\\|dae\\|3mf\\|urdf\\|sdf\\|xml";
  const auto count = [](const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
      ++found;
    }
    return found;
  };
  constexpr std::size_t commands =
      8;  // render, simulate, export, page, report, plot, inertia, study
  EXPECT_EQ(count(written("twrench.bash"), "'" + endings + "' ;;"), commands);
  EXPECT_EQ(count(written("_twrench"), "-g \\*.\\(" + zsh + "\\)"), commands);
  EXPECT_EQ(count(written("twrench.fish"),
                  "-a '(__fish_complete_suffix .toml) (__fish_complete_suffix .stl) "),
            commands);
}

TEST(Completions, OfZshPutAnEqualsSignOnlyBetweenALongOptionAndItsValue) {
  Command command{"try", "A try", {}, {}, {}, ""};
  command.options = {{{"-o", "--output"}, "FILE", "where", "", {}},
                     {{"--bare"}, "", "less", "", {}}};
  EXPECT_THAT(zsh_completion({}, {command}),
              AllOf(HasSubstr("-o --output)-o[where]:FILE:"),
                    HasSubstr("-o --output)--output=[where]:FILE:"), HasSubstr("'--bare[less]'")));
}

TEST(Completions, QuoteWhatTheShellsWouldRead) {
  Command command{"try", "It's [one]: a try", {}, {}, {}, ""};
  command.options = {{{"--a"}, "X:Y", "it's [one]: yes", "", {}}};
  EXPECT_THAT(zsh_completion({}, {command}),
              HasSubstr("'--a=[it'\\''s \\[one\\]\\: yes]:X\\:Y: '"));
  EXPECT_THAT(fish_completion({}, {command}), HasSubstr("-l a -x -d 'it'\\''s [one]: yes'"));
}

}  // namespace
}  // namespace twrench::manual
