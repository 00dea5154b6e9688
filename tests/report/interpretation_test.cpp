#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/motion_parts.h"

namespace twrench::report {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::string of_scene(const std::string& name, double duration = 96) {
  Experiment experiment{scene::load_scene(name), {}};
  experiment.scene.motion.duration = duration;
  return interpretation(solve(experiment));
}

std::string of_moments(const Eigen::Vector3d& moments, const Eigen::Vector3d& omega) {
  Experiment experiment{scene::load_scene("dzhanibekov"), {}};
  experiment.scene.body = {{}, moments.asDiagonal()};
  experiment.scene.motion.omega = omega;
  experiment.scene.motion.duration = 10;
  return interpretation(solve(experiment));
}

TEST(Interpretation, OfABodyThatTurnsOver) {
  EXPECT_THAT(
      of_scene("dzhanibekov"),
      AllOf(StartsWith("x₁₁ starts at 1 and falls to −1: the body turns over. Its intermediate "
                       "axis swings through 176 degrees"),
            HasSubstr("at 11.82, 35.45, 59.08, 82.71 s"), HasSubstr("r = 0.369 1/s"),
            HasSubstr("−90 % in 7.97 s of the 23.6 s"), HasSubstr("repeats after 47.26145 s")));
  EXPECT_THAT(of_scene("dzhanibekov", 200), HasSubstr(", …"));
  EXPECT_THAT(of_scene("dzhanibekov", 5), HasSubstr("the first flip is at 11.8 s"));
}

TEST(Interpretation, StatesHowFarEachComponentGoes) {
  // Independent: the closed form, sampled every millisecond.
  EXPECT_THAT(of_scene("dzhanibekov"), HasSubstr("x₂₁ and x₃₁ reach 1 and 0.9 in magnitude"));
}

TEST(Interpretation, ComparesWithTheInitialDirection) {
  Experiment experiment{scene::load_scene("dzhanibekov"), {}};
  experiment.scene.motion.attitude = Eigen::Quaterniond(0, 0, 1, 0);
  experiment.scene.motion.omega = Eigen::Vector3d(-1, 0.04, 0);
  EXPECT_THAT(interpretation(solve(experiment)),
              AllOf(StartsWith("The component of the principal axis x along its initial direction "
                               "starts at 1 and falls to −1"),
                    HasSubstr("The part of this axis across that direction reaches 1.")));
}

// The motion does not begin with a rotation about the intermediate axis.
TEST(Interpretation, OfABodyThatTurnsOverFarFromItsUnstableAxis) {
  const std::string text = of_moments({1, 1.01, 2}, {1, 0.5, 0.1});
  EXPECT_THAT(text, HasSubstr("turns over"));
  EXPECT_THAT(text, Not(HasSubstr("exp(rt)")));
}

TEST(Interpretation, OfAWobble) {
  EXPECT_THAT(of_scene("stable-y"),
              AllOf(StartsWith("x₂₂ stays above 0.965: the axis of least moment"),
                    HasSubstr("within 15.2 degrees"), HasSubstr("16.7 s")));
  EXPECT_THAT(of_scene("stable-z"),
              StartsWith("x₃₃ stays above 0.998: the axis of greatest moment"));
}

TEST(Interpretation, OfMotionsWithoutFlips) {
  EXPECT_THAT(of_scene("sphere"), HasSubstr("axis fixed in space"));
  EXPECT_THAT(of_moments({1, 2, 2}, {1, 1, 0}), HasSubstr("period 2πI₂/|L| = 5.62 s"));
  EXPECT_THAT(of_moments({1, 4, 6}, {2, 0.5, 1}), HasSubstr("on the separatrix"));
  EXPECT_THAT(of_moments({1, 2, 3}, {0, 0, 0}), HasSubstr("at rest"));
}

TEST(Interpretation, OfABodyWithAWheelOrAnEnergyLoss) {
  Experiment experiment{scene::load_scene("dzhanibekov"), {}};
  experiment.scene.motion.method = "taylor";
  experiment.scene.motion.wheel = Eigen::Vector3d(2000, 0, 0);
  EXPECT_THAT(interpretation(solve(experiment)),
              AllOf(HasSubstr("so is the energy"), HasSubstr("the principal axis x stays between"),
                    HasSubstr("It does not turn over in this time.")));
  experiment.scene.motion.wheel = Eigen::Vector3d(1, 0, 0);
  EXPECT_THAT(interpretation(solve(experiment)), HasSubstr("It turns over at 11.8"));
  experiment.scene.motion.wheel.reset();
  experiment.scene.motion.energy_loss_time = 20;
  EXPECT_THAT(interpretation(solve(experiment)), HasSubstr("down to the least"));
}

// The moments are 1e12 times as large; the rates are the same.
TEST(Interpretation, DoesNotDependOnTheScale) {
  const std::string small = of_moments({1e-6, 2e-6, 2.5e-6}, {10, 1, 0}),
                    large = of_moments({1e6, 2e6, 2.5e6}, {10, 1, 0});
  EXPECT_EQ(small, large);
  EXPECT_THAT(small, HasSubstr("x₁₁ stays above"));
}

}  // namespace
}  // namespace twrench::report
