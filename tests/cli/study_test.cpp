#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/twrench.h"

namespace twrench {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::StartsWith;

TEST(StudyCommand, OfEveryMethodByDefault) {
  const ScratchFolder folder;
  const Outcome run = run_twrench(folder, "study stable-y --duration 20 --format json");
  EXPECT_EQ(run.code, 0) << run.err;
  const json document = json::parse(run.out);
  EXPECT_EQ(document["scene"], "stable-y");
  EXPECT_EQ(document["methods"].size(), 14U);
  for (const json& m : document["methods"]) {
    // The closed form has no order, and the errors of the series are round-off at every tolerance.
    if (m["order"] == 0 || m["method"] == "taylor") continue;
    EXPECT_NEAR(m["order_seen"].get<double>(), m["order"].get<double>(), 0.3) << m["method"];
  }
}

TEST(StudyCommand, MethodStepAndToleranceChooseOneRun) {
  const ScratchFolder folder;
  const auto runs = [&](const std::string& arguments) {
    const json document = json::parse(run_twrench(folder, "study --format json " + arguments).out);
    EXPECT_EQ(document["methods"].size(), 1U);
    return document["methods"][0]["runs"];
  };
  const json fixed = runs("--method rk4 --step 0.125 --duration 10");
  ASSERT_EQ(fixed.size(), 1U);
  EXPECT_EQ(fixed[0]["step"], 0.125);
  EXPECT_EQ(fixed[0]["evaluations"], 320);
  const json adaptive = runs("--method rkmk45 --tolerance 1e-7 --duration 10");
  ASSERT_EQ(adaptive.size(), 1U);
  EXPECT_EQ(adaptive[0]["tolerance"], 1e-7);
  EXPECT_EQ(runs("--methods cf4 --steps 0.1,0.3,0.2 --duration 10")[0]["step"], 0.3);
}

TEST(StudyCommand, FormatsAndOutput) {
  const ScratchFolder folder;
  const std::string few = "study --methods rk4,rkmk45,exact --duration 30 ";
  EXPECT_THAT(run_twrench(folder, few).out, StartsWith("dzhanibekov: 30 s of motion"));
  EXPECT_THAT(run_twrench(folder, few + "--format csv").out, StartsWith("method,order_seen,"));
  EXPECT_EQ(run_twrench(folder, few + "-o study.txt").out, "");
  EXPECT_THAT(text_of(folder / "study.txt"), HasSubstr("rkmk45: observed order"));
}

TEST(StudyCommand, BoundsDecideTheExitCode) {
  const ScratchFolder folder;
  const std::string good = "study --method rkmk45 --tolerance 1e-10 ",
                    bad = "study --method rk4 --step 0.1 ";
  EXPECT_EQ(run_twrench(folder, good + "--max-error 1e-6 --max-energy-drift 1e-8").code, 0);
  EXPECT_EQ(run_twrench(folder, good + "--max-flip-error 1e-4").code, 0);
  EXPECT_EQ(run_twrench(folder, bad).code, 0);
  for (const char* bound :
       {"--max-error 1e-6", "--max-energy-drift 1e-8", "--max-flip-error 1e-4"}) {
    const Outcome run = run_twrench(folder, bad + bound);
    EXPECT_EQ(run.code, 1) << bound;
    EXPECT_THAT(run.err, StartsWith("twrench: study: --max-"));
    EXPECT_THAT(run.out, HasSubstr("rk4: ")) << "the study itself is there all the same";
  }
}

TEST(StudyCommand, ARefusedRunAndAMissedFlipAreOverEveryBound) {
  const ScratchFolder folder;
  EXPECT_EQ(run_twrench(folder, "study --method rk4 --step 9 --max-error 100").code, 1);
  // Euler's method flips far too often with such steps.
  EXPECT_EQ(run_twrench(folder, "study --method lie-euler --step 0.1 --max-flip-error 1e9").code,
            1);
}

TEST(StudyCommand, DrawsItsDiagrams) {
  const ScratchFolder folder;
  const Outcome run =
      run_twrench(folder, "study --methods rk4,rkmk45 --duration 20 --plot study.svg -o a.txt");
  EXPECT_EQ(run.code, 0) << run.err;
  const std::string svg = text_of(folder / "study.svg");
  for (const char* text :
       {"Order", "Work and precision", "Error against energy", "energy drift", "rk4", "rkmk45"}) {
    EXPECT_THAT(svg, HasSubstr(text));
  }
}

TEST(StudyCommand, ASphereAndABodyAtRestAreStudiedToo) {
  const ScratchFolder folder;
  EXPECT_EQ(run_twrench(folder, "study sphere --duration 20 --plot a.svg").code, 0);
  EXPECT_EQ(run_twrench(folder, "study --omega 0,0,0 --duration 20 --plot b.svg").code, 0);
}

TEST(StudyCommand, WarnsOfImpossibleMoments) {
  const ScratchFolder folder;
  const Outcome run =
      run_twrench(folder, "study --inertia 3,5,9 --methods rkmk4 --steps 0.1 --duration 10");
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.err, StartsWith("twrench: warning: "));
  EXPECT_THAT(run.err, HasSubstr("no real body has them"));
  EXPECT_EQ(std::ranges::count(run.err, '\n'), 1) << "said once";
  EXPECT_EQ(run_twrench(folder, "simulate --inertia 1,2,3 --times 1").err, "") << "a flat body";
  EXPECT_EQ(run_twrench(folder, "simulate --inertia 1,2,3.1 --times 1").code, 0);
  EXPECT_NE(run_twrench(folder, "simulate --inertia 1,2,3.1 --times 1").err, "");
}

}  // namespace
}  // namespace twrench
