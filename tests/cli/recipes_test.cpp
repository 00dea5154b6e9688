// "Add an overlay", "Add a theme" and "Add an output format" of CONTRIBUTING.md, for each existing
// name: --help-all and the document list the name, the manifest records it, and it changes the
// picture. The names are those that the program proposes for an unknown one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "cli/twrench.h"
#include "sanitizers.h"

namespace twrench {
namespace {

using nlohmann::json;
using testing::ContainsRegex;
using testing::SizeIs;

/// "one of: studio, paper, space" of the remedy, or "choose mp4 or gif".
std::vector<std::string> names_offered_for(const std::string& option,
                                           const std::string& before = "one of: ") {
  const ScratchFolder folder;
  const Outcome run = run_twrench(folder, "render " + option + " no-such-name");
  EXPECT_EQ(run.code, 2) << run.err;
  const std::size_t list = run.err.find(before);
  if (list == std::string::npos) return {};
  std::istringstream words(run.err.substr(list + before.size()));
  std::vector<std::string> names;
  for (std::string word; words >> word;) {
    if (word.ends_with(',')) word.pop_back();
    if (word != "or") names.push_back(word);
  }
  return names;
}

/// A pattern for the whole word.
std::string word(const std::string& name) { return "[^a-z-]" + name + "[^a-z-]"; }

/// Expects each name in the help of the option and in the document of scene files.
void expect_told(const std::string& option, const std::vector<std::string>& names) {
  const ScratchFolder folder;
  const std::string help = run_twrench(folder, "render --help-all").out;
  const std::size_t begin = help.find("\n  " + option + " ");
  ASSERT_NE(begin, std::string::npos) << option;
  const std::string of_option = help.substr(begin, help.find("\n  --", begin + 1) - begin) + "\n";
  const std::string document = text_of(TWRENCH_TESTS_DIR "/../docs/scene-files.md");
  for (const std::string& name : names) {
    EXPECT_THAT(of_option, ContainsRegex(word(name))) << option;
    EXPECT_THAT(document, ContainsRegex(word(name))) << option;
  }
}

struct Drawn {
  std::string digest;  ///< of the single frame
  json scene;          ///< from the manifest
};

Drawn draw(const std::string& options) {
  const ScratchFolder folder;
  const Outcome run = run_twrench(
      folder, "render --size 480x270 --frames 40 --no-video --progress none " + options);
  EXPECT_EQ(run.code, 0) << run.err;
  if (run.code != 0) return {};
  const json manifest = json::parse(text_of(folder / "out/dzhanibekov/manifest.json"));
  return {manifest["frames"][0]["sha256"], manifest["scene"]};
}

TEST(OverlayRecipe, IsTrueOfEachOverlay) {
  if (has_sanitizers) GTEST_SKIP() << "draws the same as other tests";
  const std::vector<std::string> names = names_offered_for("--show");
  ASSERT_GT(names.size(), 5U);
  expect_told("--show", names);
  EXPECT_NE(draw("--bare").digest, draw("--bare --show momentum").digest);
  for (const std::string& name : names) {
    if (name == "momentum") continue;
    // Labels need something to name, the phase is an area on the sphere, and torques and the tip
    // are those of the rotating frame.
    const std::string others = name == "phase" ? "momentum,sphere" : "momentum";
    const std::string frame = name == "torques" || name == "tip" ? "--frame rotating " : "";
    const Drawn drawn = draw(frame + "--bare --show " + others + "," + name);
    EXPECT_NE(drawn.digest, draw(frame + "--bare --show " + others).digest)
        << name << " draws nothing";
    const json shown = drawn.scene["overlay"]["show"];
    EXPECT_THAT(shown.get<std::vector<std::string>>(), testing::Contains(name));
    EXPECT_EQ(shown.size(), name == "phase" ? 3U : 2U);
  }
}

TEST(ThemeRecipe, IsTrueOfEachTheme) {
  const std::vector<std::string> names = names_offered_for("--theme");
  ASSERT_GT(names.size(), 2U);
  expect_told("--theme", names);
  std::set<std::string> digests;
  for (const std::string& name : names) {
    const Drawn drawn = draw("--theme " + name);
    digests.insert(drawn.digest);
    EXPECT_EQ(drawn.scene["look"]["theme"], name);
  }
  EXPECT_THAT(digests, SizeIs(names.size())) << "two themes draw the same picture";
}

TEST(OutputFormatRecipe, IsTrueOfEachOutputFormat) {
  const std::vector<std::string> names = names_offered_for("--container", "choose ");
  ASSERT_GT(names.size(), 3U);
  expect_told("--container", names);
  const ScratchFolder folder;
  for (const std::string& name : names) {
    const Outcome run = run_twrench(
        folder, "render --size 64x48 --frames 0-2 --no-frames --progress none -o film." + name);
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_THAT(folder.names(), testing::Contains("film." + name));
  }
}

TEST(ViewRecipe, IsTrueOfEachView) {
  const std::vector<std::string> names = names_offered_for("--view");
  ASSERT_GT(names.size(), 3U);
  expect_told("--view", names);
  std::set<std::string> digests;
  for (const std::string& name : names) {
    const Drawn drawn = draw("--view " + name);
    digests.insert(drawn.digest);
    EXPECT_EQ(drawn.scene["overlay"]["view"], name);
  }
  EXPECT_THAT(digests, SizeIs(names.size())) << "two views draw the same picture";
}

}  // namespace
}  // namespace twrench
