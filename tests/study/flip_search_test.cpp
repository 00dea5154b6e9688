#include <gtest/gtest.h>
#include <twrench/motion/error.h>
#include <twrench/motion/exact.h>
#include <twrench/study/flip_search.h>

#include <cmath>
#include <string_view>

#include "motion/random_bodies.h"
#include "motion/reference.h"

namespace twrench::study {
namespace {

using Eigen::Vector3d;

std::vector<double> flips_seen(const motion::FreeBody& body, std::string_view method, double step,
                               double t_end) {
  const motion::Method& m = motion::find_method(method);
  FlipSearch search(body, m);
  motion::visit_steps(body, m, {.step = step, .tolerance = 1e-13}, t_end,
                      [&](const motion::AcceptedStep& s) { search.visit(s); });
  return search.times();
}

TEST(FlipSearch, FindsTheExactInstantsOnTheExactMotion) {
  motion::RandomBodies random;
  for (int n = 0; n < 100; ++n) {
    const Vector3d moments = random.moments(), omega = random.omega();
    const motion::FreeBody body(moments.asDiagonal(), omega);
    const motion::ExactMotion motion(body);
    const double end = 20 / omega.norm();
    const std::vector<double> predicted = motion.flip_times(end);
    const std::vector<double> seen = flips_seen(body, "exact", 0.05 / omega.norm(), end);
    ASSERT_GE(seen.size(), predicted.size());  // the last step may pass the end
    for (std::size_t i = 0; i < predicted.size(); ++i) {
      EXPECT_NEAR(seen[i], predicted[i], 1e-11 * end) << moments << "\n" << omega;
    }
  }
}

TEST(FlipSearch, FindsThemBetweenLongStepsOfAMethod) {
  const motion::FreeBody wrench = motion::reference_case("wrench-a").body;
  const std::vector<double> predicted = motion::ExactMotion(wrench).flip_times(90);
  for (const auto& [method, step] : {std::pair{"suzuki4", 0.01}, std::pair{"rkmk45", 0.1}}) {
    const std::vector<double> seen = flips_seen(wrench, method, step, 90);
    ASSERT_EQ(seen.size(), predicted.size());
    for (std::size_t i = 0; i < seen.size(); ++i) EXPECT_NEAR(seen[i], predicted[i], 1e-8);
  }
}

TEST(FlipSearch, PassesASingularAttitudeOfAMethodThatLeavesTheGroup) {
  // Toutatis, whose moments are huge. Euler's X grows beyond 1e20 and becomes singular.
  const Eigen::Matrix3d inertia{
      {8.62405565422451e+25, 8.802463825757149e+21, 1.9640458339687876e+23},
      {8.802463825757149e+21, 2.8619637482337367e+25, 5.140926132774462e+22},
      {1.9640458339687876e+23, 5.140926132774462e+22, 9.128647695728283e+25}};
  for (int i = 0; i < 200; ++i) {
    const motion::FreeBody toutatis(inertia, {0.999238 + 1e-6 * i, 0.050118, -0.038878});
    try {
      for (const double t : flips_seen(toutatis, "euler", 0.2, 200)) EXPECT_TRUE(std::isfinite(t));
    } catch (const motion::MotionError& error) {
      EXPECT_EQ(error.reason(), motion::MotionError::Reason::diverged);
    }
  }
}

TEST(FlipSearch, DoesNotCountTheStart) {
  // omega along the intermediate axis is zero at t = 0 and positive afterwards.
  const motion::FreeBody body(Vector3d(1, 2, 3).asDiagonal(), {0.5, 0, 0.7});
  const std::vector<double> predicted = motion::ExactMotion(body).flip_times(30);
  const std::vector<double> seen = flips_seen(body, "exact", 0.01, 30);
  ASSERT_EQ(seen.size(), predicted.size());
  EXPECT_NEAR(seen[0], predicted[0], 1e-12);
}

// With I = (3, 5, 9), L = (0, 2, 0.01) and steps of 0.1 s, flips are 59.0554 s apart. The values
// are known independently to the digits given here.
TEST(FlipSearch, RungeKuttaAsPrintedFlipsTooLateAndUnevenly) {
  const motion::FreeBody body(Vector3d(3, 5, 9).asDiagonal(), {0, 2.0 / 5, 0.01 / 9});
  EXPECT_NEAR(motion::ExactMotion(body).flips()->interval, 59.055443523193, 1e-9);
  const auto intervals = [&](std::string_view method) {
    const std::vector<double> times = flips_seen(body, method, 0.1, 360);
    std::vector<double> between;
    for (std::size_t i = 1; i < times.size(); ++i) between.push_back(times[i] - times[i - 1]);
    return between;
  };
  const std::vector<double> printed = intervals("rk4"), corrected = intervals("rkmk4");
  const std::vector<double> known{60.6, 63.0, 68.1, 67.9, 62.9};
  ASSERT_EQ(printed.size(), 5U);
  ASSERT_GE(corrected.size(), 5U);
  for (std::size_t i = 0; i < printed.size(); ++i) EXPECT_NEAR(printed[i], known[i], 0.06) << i;
  for (const double interval : corrected) {
    EXPECT_GT(interval, 59.0540);
    EXPECT_LT(interval, 59.0553);
  }
}

}  // namespace
}  // namespace twrench::study
