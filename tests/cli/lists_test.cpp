#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/twrench.h"

namespace twrench {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::StartsWith;

TEST(Lists, MethodsOneALine) {
  const ScratchFolder folder;
  const Outcome run = run_twrench(folder, "methods");
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.out, StartsWith("euler "));
  EXPECT_THAT(run.out, HasSubstr("\nrkf45 "));
}

TEST(Lists, ScenesOneALine) {
  const ScratchFolder folder;
  const Outcome run = run_twrench(folder, "scenes");
  EXPECT_EQ(run.code, 0);
  for (const char* name : {"dzhanibekov", "stable-y", "stable-z", "sphere"}) {
    EXPECT_THAT(run.out, HasSubstr(name));
  }
}

TEST(Lists, VersionAndHelp) {
  const ScratchFolder folder;
  EXPECT_THAT(run_twrench(folder, "--version").out, StartsWith("twrench "));
  for (const char* command : {"", "render", "simulate", "plot", "inertia", "study", "encode",
                              "compare", "doctor", "methods", "scenes"}) {
    const Outcome run = run_twrench(folder, std::string(command) + " --help");
    EXPECT_EQ(run.code, 0) << command;
    EXPECT_EQ(run.err, "") << command;
    EXPECT_THAT(run.out,
                HasSubstr(*command == 0 ? "Compute the trajectory and write it as CSV or JSON"
                                        : "Example: twrench "))
        << command;
  }
}

TEST(Inertia, OfTheWrenchAsJson) {
  const ScratchFolder folder;
  const json body = json::parse(run_twrench(folder, "inertia --format json").out);
  EXPECT_NEAR(body["mass"], 252.584, 1e-3);
  EXPECT_NEAR(body["inertia"][0][0], 982.2713030224087, 1e-9);
  EXPECT_NEAR(body["inertia"][1][1], 722.6710300807721, 1e-9);
  EXPECT_NEAR(body["inertia"][2][2], 1578.650308428871, 1e-9);
  EXPECT_EQ(body["inertia"][0][1], 0.0);
}

TEST(Inertia, OfMomentsAlone) {
  const ScratchFolder folder;
  const json body = json::parse(run_twrench(folder, "inertia --inertia 5,3,4 --format json").out);
  EXPECT_TRUE(body["mass"].is_null());
  EXPECT_EQ(body["principal_moments"], json({3.0, 4.0, 5.0}));
  EXPECT_THAT(run_twrench(folder, "inertia --inertia 5,3,4").out, HasSubstr("not given"));
}

}  // namespace
}  // namespace twrench
