#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/twrench.h"

namespace twrench {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(Export, WritesWhatItsEndingSays) {
  const ScratchFolder folder;
  for (const auto& [name, head] : {std::pair("a.glb", "glTF\2"),
                                   {"a.py", "# Written by twrench "},
                                   {"a.aem", "CCSDS_AEM_VERS = 1.0\n"},
                                   {"a.csv", "t,x11,"},
                                   {"a.json", "{\n \"scene\""}}) {
    const Outcome run = run_twrench(folder, std::string("export --duration 1 -o ") + name);
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(run.out + run.err, "");
    EXPECT_THAT(text_of(folder / name), StartsWith(head));
  }
}

TEST(Export, IsToTheByteWhatSimulateWrites) {
  const ScratchFolder folder;
  const std::string motion = "stable-y --method rk4 --duration 1.05 --fps 20 ";
  for (const std::string format : {"csv", "json"}) {
    const std::string simulated =
        run_twrench(folder, "simulate " + motion + "--format " + format).out;
    EXPECT_EQ(run_twrench(folder, "export " + motion + "-o a." + format).code, 0);
    EXPECT_EQ(text_of(folder / ("a." + format)), simulated);
    EXPECT_EQ(run_twrench(folder, "export " + motion + "-o - --format " + format).out, simulated);
  }
}

// The bound is against the exact motion, which these formats contain.
TEST(Export, HasTheExactMotionWhateverTheMethod) {
  const ScratchFolder folder;
  for (const std::string name : {"a.glb", "a.py", "a.aem"}) {
    ASSERT_EQ(run_twrench(folder, "export --duration 3 -o " + name).code, 0);
    const std::string before = text_of(folder / name);
    ASSERT_EQ(run_twrench(folder, "export --duration 3 --method euler -o " + name).code, 0);
    EXPECT_EQ(text_of(folder / name), before) << "and the same bytes each time";
  }
}

TEST(Export, HasMoreKeysForASmallerAngle) {
  const ScratchFolder folder;
  ASSERT_EQ(run_twrench(folder, "export -o a.glb").code, 0);
  ASSERT_EQ(run_twrench(folder, "export -o b.glb --max-angle 1e-5").code, 0);
  EXPECT_GT(std::filesystem::file_size(folder / "b.glb"),
            std::filesystem::file_size(folder / "a.glb") + 50'000);
}

TEST(Export, RefusesWhatItCannotKeep) {
  const ScratchFolder folder;
  const auto expect_refused = [&](const std::string& options, int code, const char* message) {
    const Outcome run = run_twrench(folder, "export " + options);
    EXPECT_EQ(run.code, code) << options;
    EXPECT_THAT(run.err, StartsWith("twrench: error: "));
    EXPECT_THAT(run.err, HasSubstr(message));
    EXPECT_FALSE(std::filesystem::exists(folder / "a.glb")) << options;
    EXPECT_FALSE(std::filesystem::exists(folder / "a.py")) << options;
  };
  expect_refused("-o a.glb --duration 1e9", 2, "only keys ");
  expect_refused("-o a.glb --duration 1e9", 2,
                 "take a larger --max-angle, or a shorter --duration");
  expect_refused("-o a.py --duration 1e9 --speed 1", 2, "but Blender has at most 1048574");
  expect_refused("-o a.py --inertia 1,2,3 --omega 1e6,1e6,1e3 --speed 1 --duration 1000", 2,
                 "at 60000 frames the times of keys");
  expect_refused("-o a.py --fps 1e-9", 2, "its frame rate is 1e-09 per second");
  expect_refused("-o a.glb --max-angle 1e-7", 2,
                 "--max-angle: is 1e-07, but must be at least 1e-06");
  expect_refused("-o a.fbx", 2, "its name must end in .glb, .py, .aem, .csv, .json or .npz");
  expect_refused("-o -", 2, "--format: is needed for standard output");
  expect_refused("-o a.aem --epoch 2026-02-30T00:00:00", 2, "--epoch: is 2026-02-30T00:00:00");
  expect_refused("-o /dev/full --format glb", 5, "No space left on device");
  expect_refused("-o no/such.glb", 5, "No such file or directory");
}

TEST(Export, PlaysAMotionOfDaysAtTheSpeedOfTheFilm) {
  const ScratchFolder folder;
  ASSERT_EQ(run_twrench(folder, "export toutatis -o a.glb").code, 0);
  EXPECT_THAT(text_of(folder / "a.glb"), HasSubstr("\"max\":[16.0]"));  // s
  ASSERT_EQ(run_twrench(folder, "export -o a.glb").code, 0);
  EXPECT_THAT(text_of(folder / "a.glb"), HasSubstr("\"max\":[96.0]"));
}

// 1 rad/s at 10,000 s, where float32 times are 1e-3 s apart.
TEST(Export, TellsWhatAPlayerInFloat32Loses) {
  const ScratchFolder folder;
  const std::string motion = "export --inertia 1,2,3 --omega 1,0,0 -o a.glb --duration ";
  EXPECT_THAT(run_twrench(folder, motion + "10000").err,
              HasSubstr("off by up to 0.00049 rad at 10000 s, where these are 0.00098 s apart"));
  EXPECT_EQ(run_twrench(folder, motion + "1000").err, "");
}

}  // namespace
}  // namespace twrench
