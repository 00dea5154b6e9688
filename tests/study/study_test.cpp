#include <gtest/gtest.h>
#include <twrench/base/error.h>
#include <twrench/study/study.h>

#include <cmath>
#include <vector>

#include "motion/reference.h"
#include "sanitizers.h"
#include "study/ladder.h"

namespace twrench::study {
namespace {

motion::FreeBody wrench() { return motion::reference_case("wrench-a").body; }

StudyPlan plan_for(std::initializer_list<const char*> names, double duration) {
  StudyPlan plan{{}, step_ladder(duration, 1), {1e-6, 1e-8, 1e-10}, 0.1, duration};
  for (const char* name : names) plan.methods.push_back(&motion::find_method(name));
  return plan;
}

TEST(Study, SeesTheOrderOfEveryMethod) {
  if (has_sanitizers) GTEST_SKIP() << "repeats the computation with other numbers";
  StudyPlan plan = plan_for({}, 96);
  plan.tolerances = tolerance_ladder();
  for (const motion::Method& method : motion::methods()) plan.methods.push_back(&method);
  for (const MethodStudy& m : run_study(wrench(), plan).methods) {
    if (m.method->order.value_or(9) > 8) {  // none, or too steep to measure
      EXPECT_FALSE(m.order);
      continue;
    }
    ASSERT_TRUE(m.order) << m.method->name;
    EXPECT_NEAR(*m.order, *m.method->order, 0.25) << m.method->name;
  }
}

TEST(Study, ErrorIsThatAgainstTheReference) {
  const motion::ReferenceCase c = motion::reference_case("wrench-a");
  const motion::Sample& end = c.samples[4];  // t = 50
  StudyPlan plan = plan_for({"midpoint"}, end.t);
  plan.steps = {0.05};
  const Study result = run_study(c.body, plan);
  const StudyRun& run = result.methods[0].runs[0];
  const std::vector<double> times{end.t, 10};
  const auto samples =
      motion::integrate(c.body, motion::find_method("midpoint"), {.step = 0.05}, times).samples;
  EXPECT_NEAR(run.error, (samples[0].X - end.X).norm(), 1e-12);
  EXPECT_EQ(result.early, 10);
  EXPECT_NEAR(run.early_error, (samples[1].X - c.samples[2].X).norm(), 1e-12);
  EXPECT_EQ(run.steps, 1000);
  EXPECT_EQ(run.evaluations, 2000);
  EXPECT_EQ(run.step, 0.05);
  EXPECT_GT(run.cpu_seconds, 0);
}

TEST(Study, ReportsItsProgress) {
  StudyPlan plan = plan_for({"midpoint", "rk4"}, 20);
  plan.steps = {0.1, 0.05};
  std::vector<std::size_t> parts;
  plan.progress = [&](std::size_t done, std::size_t total) {
    EXPECT_EQ(total, 4U);
    parts.push_back(done);
  };
  run_study(wrench(), plan);
  EXPECT_EQ(parts, (std::vector<std::size_t>{1, 2, 3, 4}));
}

TEST(Study, TellsWhatAMethodConserves) {
  StudyPlan plan = plan_for({"euler", "lie-euler", "implicit-trapezoid"}, 20);
  plan.steps = {0.05};
  const Study result = run_study(wrench(), plan);
  const StudyRun &euler = result.methods[0].runs[0], &group = result.methods[1].runs[0],
                 &trapezoid = result.methods[2].runs[0];
  EXPECT_GT(euler.orthogonality_error, 1e-2);
  EXPECT_LT(group.orthogonality_error, 1e-13);
  EXPECT_LT(group.momentum_error, 1e-13);
  EXPECT_GT(group.energy_drift, 1e-2);
  EXPECT_LT(trapezoid.energy_drift, 1e-13);
  double largest = 0;
  for (const double drift : group.drift_in_time) largest = std::max(largest, drift);
  EXPECT_EQ(largest, group.energy_drift);
}

TEST(Study, HoldsFlipsAgainstThePrediction) {
  StudyPlan plan = plan_for({"rk4", "exact"}, 96);
  plan.steps = {0.1};
  const Study result = run_study(wrench(), plan);
  ASSERT_EQ(result.flip_times.size(), 4U);
  const StudyRun &rk4 = result.methods[0].runs[0], &exact = result.methods[1].runs[0];
  ASSERT_EQ(rk4.flips.size(), 4U);
  EXPECT_NEAR(rk4.flip_error, std::abs(rk4.flips[3] - result.flip_times[3]), 1e-12);
  EXPECT_GT(rk4.flip_error, 1);
  EXPECT_LT(exact.flip_error, 1e-12);
}

/// Motions without a closed form: with a wheel, with energy loss, and with both.
TEST(Study, HasAReferenceForAWheelAndEnergyLoss) {
  for (const motion::ReferenceCase& c : motion::constant_momentum_cases()) {
    const motion::Sample& end = c.samples[1];
    StudyPlan plan = plan_for({"rk4", "rkmk4", "cf4", "rkmk45", "taylor"}, end.t);
    const Study result = run_study(c.body, plan);
    const bool loses = c.body.energy_loss() > 0;
    EXPECT_EQ(result.reference->name, "taylor") << c.name;
    EXPECT_FALSE(result.flips);
    const StudyRun& finest = result.methods[1].runs.back();
    const auto sample = motion::integrate(c.body, motion::find_method("rkmk4"),
                                          {.step = finest.step}, std::vector{end.t})
                            .samples[0];
    EXPECT_NEAR(finest.error, (sample.X - end.X).norm(), 1e-13) << c.name;
    for (const MethodStudy& m : result.methods) {
      if (m.method->order == 4) {
        EXPECT_NEAR(m.order.value(), 4, 0.4) << c.name;  // short, so it has few points
      }
      const StudyRun& run = m.runs.back();
      EXPECT_LT(run.error, 1e-5) << c.name << " " << m.method->name;
      EXPECT_LT(run.energy_drift, 2e-7) << c.name << " " << m.method->name;
      EXPECT_EQ(run.flips.size(), result.flip_times.size()) << c.name << " " << m.method->name;
      if (loses) {
        EXPECT_TRUE(run.flips.empty());
      }
    }
    EXPECT_NEAR(result.methods[3].runs.back().estimate->median_ratio, 1, 0.1) << c.name;
  }
}

/// The reference of a body that turns over nevertheless finds the same flips as the closed form of
/// that body without its negligible wheel.
TEST(Study, FindsTheFlipsOfABodyWithAWheel) {
  const motion::FreeBody body = wrench();
  const motion::FreeBody with_wheel(body.inertia(), body.omega(), Eigen::Matrix3d::Identity(),
                                    {.wheel = 1e-9 * body.body_momentum()});
  const std::vector<double> expected = motion::ExactMotion(body).flip_times(96);
  const Study result = run_study(with_wheel, plan_for({"taylor"}, 96));
  ASSERT_EQ(result.flip_times.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(result.flip_times[i], expected[i], 1e-4);
  }
}

TEST(Study, EstimateOfTheEmbeddedPairs) {
  const Study result = run_study(wrench(), plan_for({"rkf45", "rkmk45", "rk4"}, 20));
  EXPECT_NEAR(result.methods[0].estimate_exponent.value(), -2, 0.1);
  EXPECT_NEAR(result.methods[1].estimate_exponent.value(), 0, 0.1);
  EXPECT_FALSE(result.methods[2].estimate_exponent);
  const StudyRun& run = result.methods[1].runs[2];
  EXPECT_EQ(run.tolerance, 1e-10);
  EXPECT_NEAR(run.estimate->median_ratio, 1, 0.1);
  EXPECT_NEAR(run.step, 20.0 / static_cast<double>(run.steps), 0.1 * run.step);
}

TEST(Study, ARefusedStepIsARunWithItsReason) {
  StudyPlan plan = plan_for({"rkmk4", "lie-euler"}, 1000);
  plan.steps = {50, 0.1};
  const Study result = run_study(wrench(), plan);
  const MethodStudy& m = result.methods[0];
  EXPECT_NE(m.runs[0].failure.find("longer than a turn of the body"), std::string::npos);
  EXPECT_EQ(m.runs[1].failure, "");
  EXPECT_NE(result.methods[1].runs[0].failure, "");
  EXPECT_EQ(result.methods[1].runs[1].failure, "");
}

TEST(Study, RefusesAPlanThatCannotBe) {
  const auto refused = [](const StudyPlan& plan) -> std::string {
    try {
      run_study(wrench(), plan);
    } catch (const InvalidArgument& error) {
      return error.quantity();
    }
    return "nothing";
  };
  StudyPlan plan = plan_for({"rk4", "rkmk45"}, 1);
  plan.duration = 0;
  EXPECT_EQ(refused(plan), "duration");
  plan.duration = 1;
  plan.steps = {0.1, -0.1};
  EXPECT_EQ(refused(plan), "step");
  plan.steps = {};
  EXPECT_EQ(refused(plan), "steps");
  plan.steps = {0.1};
  plan.tolerances = {1e-16};
  EXPECT_EQ(refused(plan), "tolerance");
}

TEST(Study, ABodyAtRestHasNoErrorAndNoFlips) {
  const motion::FreeBody rest(Eigen::Vector3d(1, 2, 3).asDiagonal(), Eigen::Vector3d::Zero());
  StudyPlan plan = plan_for({"rk4", "rkmk45", "euler"}, 10);
  const Study result = run_study(rest, plan);
  EXPECT_FALSE(result.flips);
  for (const MethodStudy& m : result.methods) {
    EXPECT_FALSE(m.order);
    for (const StudyRun& run : m.runs) {
      EXPECT_EQ(run.error, 0);
      EXPECT_TRUE(std::isnan(run.flip_error));
    }
  }
}

}  // namespace
}  // namespace twrench::study
