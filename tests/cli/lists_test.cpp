#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>

#include "cli/twrench.h"

namespace twrench {
namespace {

using nlohmann::json;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::StartsWith;

TEST(Lists, MethodsOneALine) {
  const ScratchFolder folder;
  const Outcome run = run_twrench(folder, "methods");
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.out, StartsWith("euler "));
  EXPECT_THAT(run.out, HasSubstr("\nrkf45 "));
}

TEST(Lists, NoCaseHasAnEmptyName) {
  const ScratchFolder folder;
  const Outcome run = run_twrench(folder, "cases ''");
  EXPECT_EQ(run.code, 2);
  EXPECT_EQ(run.out, "");
}

// As other programs, it ends in silence when `head` has enough.
TEST(Lists, EndWithTheirReader) {
  const ScratchFolder folder;
  const Outcome run = run_shell(
      folder, "{ \"$TWRENCH\" simulate --fps 1000 --method exact; echo $? >code; } | true");
  EXPECT_EQ(run.err, "");
  std::string code;
  std::ifstream(folder / "code") >> code;
  EXPECT_EQ(code, "141");
}

TEST(Lists, ScenesOneALine) {
  const ScratchFolder folder;
  const Outcome run = run_twrench(folder, "scenes");
  EXPECT_EQ(run.code, 0);
  for (const char* name :
       {"dzhanibekov", "calm", "stable-y", "stable-z", "sphere", "tao-disk", "explain",
        "explain-nb", "explain-short", "t-handle", "wing-nut", "tennis-racket", "phone", "book",
        "hammer", "toutatis", "explorer-1", "dual-spin", "t-handle-wheel"}) {
    EXPECT_THAT("\n" + run.out, ContainsRegex(std::string("\n") + name + " +[A-Z]"));
  }
}

TEST(Lists, ScenesSayWhatATiltDoes) {
  const ScratchFolder folder;
  const std::string scenes = run_twrench(folder, "scenes").out;
  EXPECT_THAT(scenes, HasSubstr("The Dzhanibekov effect; unstable about x, doubles every 1.88 s"));
  EXPECT_THAT(scenes, ContainsRegex("stable-z [^\n]*; stable about z, wobbles every 7.4. s"));
  EXPECT_THAT(scenes, ContainsRegex("sphere [^\n]*; neutral about x; moments 1 : 1 : 1; "));
}

// The moments are from the files of the scenes. The interval of "dzhanibekov" is from
// docs/exact.md, the others from an independent quadrature. Toutatis turns about its long axis in
// 5.41 d, and wobbles about it.
TEST(Lists, ScenesSayHowOftenTheyFlip) {
  const ScratchFolder folder;
  const std::string scenes = run_twrench(folder, "scenes").out;
  EXPECT_THAT(scenes, HasSubstr("; moments 1 : 1.36 : 2.18; flips every 23.6 s\n"));
  EXPECT_THAT(scenes, ContainsRegex("stable-z [^\n]*; does not flip\n"));
  EXPECT_THAT(scenes, ContainsRegex("sphere [^\n]*; does not flip\n"));
  EXPECT_THAT(scenes,
              ContainsRegex("tennis-racket [^\n]*; moments 1 : 9.07 : 10; flips every 1.62 s\n"));
  EXPECT_THAT(scenes,
              ContainsRegex("t-handle [^\n]*; moments 1 : 2.23 : 3.14; flips every 2.37 s\n"));
  EXPECT_THAT(
      scenes,
      ContainsRegex("toutatis [^\n]*; wobbles about y every 5.41 d; moments 1 : 3.13 : 3.29; does "
                    "not flip\n"));
  EXPECT_THAT(scenes, ContainsRegex("explorer-1 [^\n]*; loses energy within 34.2 min; moments"));
}

TEST(Lists, CasesAsATable) {
  const ScratchFolder folder;
  const Outcome run = run_twrench(folder, "cases");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, ContainsRegex("^name +inertia +omega +duration +source\n"));
  EXPECT_THAT(run.out, ContainsRegex("\nnasa-tumbling-brick +0.00189422, 0.006211019, 0.007194665 "
                                     "slug ft\\^2 +10, 20, 30 deg/s +30 s +NASA "));
  EXPECT_THAT(run.out, ContainsRegex("\nkynema-precession +1, 1, 0.5 +0.5, 0.5, 1 rad/s +5 s +K"));
  const std::string csv = run_twrench(folder, "cases --format csv").out;
  EXPECT_THAT(csv, StartsWith("name,I1,I2,I3,inertia_unit,wx,wy,wz,duration,title,source\n"));
  EXPECT_THAT(csv, HasSubstr("\ngazebo-box,0.8083333333333333,0.6833333333333333,"
                             "0.14166666666666666,\"kg m^2\",0.1,5,"));
  const json list = json::parse(run_twrench(folder, "cases --format json").out)["cases"];
  ASSERT_GE(list.size(), 6U);
  EXPECT_EQ(list[0]["name"], "basilisk-spacecraft");
  EXPECT_EQ(list[0]["inertia"], json({500.0, 200.0, 300.0}));
}

TEST(Lists, OneCaseWithItsExactValues) {
  const ScratchFolder folder;
  const Outcome run = run_twrench(folder, "cases kynema-precession -o case.txt");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.out, "");
  const std::string text = text_of(folder / "case.txt");
  EXPECT_THAT(text, StartsWith("case      kynema-precession: Precession of a symmetric body\n"));
  EXPECT_THAT(text, HasSubstr("\ninertia   1, 1, 0.5\nomega     0.5, 0.5, 1 rad/s\n"));
  EXPECT_THAT(text, HasSubstr("quaternion, at t = 5 s, published: off by up to 0.00155\n"));
  EXPECT_THAT(text,
              ContainsRegex("\n  y +-0.30157681970585326 +-0.30312423905729[0-9]+ +0.0015\n"));
  EXPECT_THAT(text, HasSubstr("exact values at t = 5 s\n  omega, body axes, rad/s\n"));
  const std::string nasa = run_twrench(folder, "cases nasa-tumbling-brick").out;
  EXPECT_THAT(nasa, HasSubstr("\nomega     10, 20, 30 deg/s\n          0.17453292519943295, "));
  EXPECT_THAT(nasa, HasSubstr("omega, deg/s, at t = 30 s, published by simulator 05: off by"));
  EXPECT_THAT(run_twrench(folder, "cases basilisk-spacecraft").out,
              HasSubstr("mrp, at t = 10 s, published: right to its last digit\n"));
  const json document =
      json::parse(run_twrench(folder, "cases basilisk-spacecraft --format json").out);
  EXPECT_NEAR(document["published"][0]["exact"][0], 0.3730342848905, 5e-14);
  EXPECT_EQ(document["exact"].back()["t"], 10.0);
}

TEST(Lists, VersionAndHelp) {
  const ScratchFolder folder;
  const std::string version = run_twrench(folder, "--version").out;
  EXPECT_TRUE(std::regex_search(version, std::regex("^twrench [0-9]+\\.[0-9]+\\.[0-9]+\n")))
      << version;  // scripts read the first line
  for (const char* command :
       {"", "render", "simulate", "export", "plot", "inertia", "study", "encode", "compare",
        "doctor", "methods", "scenes", "schema", "cases"}) {
    const Outcome run = run_twrench(folder, std::string(command) + " --help");
    EXPECT_EQ(run.code, 0) << command;
    EXPECT_EQ(run.err, "") << command;
    EXPECT_THAT(
        run.out,
        HasSubstr(*command == 0 ? "Compute the trajectory and write it as CSV, JSON or NumPy arrays"
                                : "Example: twrench "))
        << command;
  }
}

// LICENSE and THIRD-PARTY.md contain the licences in the output.
TEST(Lists, VersionNamesTheLicences) {
  const ScratchFolder folder;
  const std::string version = run_twrench(folder, "--version").out;
  const std::filesystem::path project = std::filesystem::path(TWRENCH_TESTS_DIR).parent_path();
  EXPECT_THAT(version,
              HasSubstr("Copyright (c) 2026 the twrench authors. MIT License: see LICENSE."));
  EXPECT_THAT(text_of(project / "LICENSE"),
              StartsWith("MIT License\n\nCopyright (c) 2026 the twrench authors\n"));
  EXPECT_THAT(version, HasSubstr("see THIRD-PARTY.md"));
  const std::string notices = text_of(project / "THIRD-PARTY.md");
  for (const auto& [font, licence, identifier] :
       {std::array{"Roboto", "Apache License 2.0", "Apache-2.0"},
        std::array{"Fira Code", "SIL Open Font License 1.1", "OFL-1.1"}}) {
    EXPECT_THAT(version, HasSubstr(std::string(font) + " (" + licence + ")"));
    EXPECT_THAT(notices, ContainsRegex(std::string("\n\\| ") + font + "[^\n]*" + identifier));
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

TEST(Inertia, PredictsWhatATiltDoes) {
  const ScratchFolder folder;
  EXPECT_THAT(run_twrench(folder, "inertia").out,
              HasSubstr("\n  unstable about x, doubles every 1.88 s at 1 rad/s\n"));
  const json stability = json::parse(run_twrench(folder, "inertia --format json").out)["stability"];
  ASSERT_EQ(stability.size(), 3U);
  EXPECT_EQ(stability[1]["axis"], "x");
  EXPECT_EQ(stability[1]["kind"], "unstable");
  EXPECT_NEAR(stability[1]["rate"], 0.36838374, 1e-8);
  EXPECT_NEAR(stability[1]["doubling_time"], 1.88159, 1e-5);
  EXPECT_EQ(stability[0]["kind"], "stable");
  EXPECT_NEAR(stability[0]["period"], 16.6, 0.05);
  EXPECT_FALSE(stability[0].contains("doubling_time"));
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
