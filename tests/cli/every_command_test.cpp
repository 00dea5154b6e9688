// Every command with every built-in scene and with bodies of any scale. Early commands had defaults
// only for the T-wrench, whose motion takes a minute and a half.
#include "cli/every_command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "cli/random_scene.h"
#include "cli/twrench.h"
#include "sanitizers.h"

namespace twrench {
namespace {

using testing::IsEmpty;

std::vector<std::string> faults_of(const ScratchFolder& folder, const CommandSubject& subject,
                                   Thoroughness thoroughness) {
  const RunCommand run = [&](const std::string& arguments) {
    Outcome outcome = run_twrench(folder, arguments);
    return CommandEnd{outcome.code, std::move(outcome.out), std::move(outcome.err)};
  };
  return faults_of_every_command(subject, folder.path(), run, thoroughness);
}

class BuiltInScene : public testing::TestWithParam<std::string> {};

/// Scenes with which the commands take the same paths as with the others.
constexpr std::array like_others{"calm",           "stable-y",  "stable-z", "explain-nb",
                                 "explain-short",  "t-handle",  "wing-nut", "tennis-racket",
                                 "phone",          "hammer",    "toutatis", "dual-spin",
                                 "t-handle-wheel", "explorer-1"};

TEST_P(BuiltInScene, WorksWithEveryCommand) {
  const ScratchFolder folder;
  const std::string name = GetParam();
  if (has_sanitizers && std::ranges::count(like_others, name) > 0) {
    GTEST_SKIP() << "takes the same paths as others";
  }
  // The full outputs take seconds per body. The torture test makes them for each body.
  const bool full = name == "toutatis";
  EXPECT_THAT(faults_of(folder, {scene::load_scene(name), name, name, "--scene " + name},
                        full ? Thoroughness::full : Thoroughness::quick),
              IsEmpty());
}

std::string name_of(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::ranges::replace(name, '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, BuiltInScene, testing::ValuesIn(scene::builtin_scene_names()),
                         name_of);

class RandomBody : public testing::TestWithParam<int> {};

TEST_P(RandomBody, WorksWithEveryCommand) {
  if (has_sanitizers) GTEST_SKIP() << "repeats the computation with other numbers";
  constexpr std::uint32_t seed = 2026;
  const ScratchFolder folder;
  const auto number = static_cast<std::uint32_t>(GetParam());
  const RandomScene random = random_scene(seed, number);
  system::write_file_atomically(folder / "own.toml", random.toml);
  EXPECT_THAT(faults_of(folder, subject_of(random, number % 2 == 0),
                        number == 7 ? Thoroughness::full : Thoroughness::quick),
              IsEmpty())
      << random.toml;
}

INSTANTIATE_TEST_SUITE_P(Scales, RandomBody, testing::Range(0, 20));

}  // namespace
}  // namespace twrench
