#include "motion/visible_error.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <twrench/motion/exact.h>
#include <twrench/motion/trajectory.h>

#include <numbers>

namespace twrench::motion {
namespace {

std::string error_of(const FreeBody& body, const char* method, const StepControl& control,
                     double t) {
  const Method& found = find_method(method);
  const std::vector<double> times{t};
  return visible_error(body, found, integrate(body, found, control, times).samples.front());
}

FreeBody body_of(const Eigen::Vector3d& moments, const Eigen::Vector3d& omega) {
  return FreeBody(moments.asDiagonal().toDenseMatrix(), omega);
}

// On the separatrix of moments 1, 5, 9 every method leaves the exact motion after some turns.
TEST(VisibleError, OnTheSeparatrixIsNamed) {
  const FreeBody body = body_of({1, 5, 9}, {3, 1, 1});
  EXPECT_EQ(error_of(body, "rkmk45", {}, 10),
            "rkmk45 is off by 180 degrees at 10 s; the method exact is not");
  EXPECT_EQ(error_of(body, "rkmk45", {}, 1), "");
  EXPECT_EQ(error_of(body, "exact", {}, 10), "");
}

TEST(VisibleError, OfALongStepIsNamed) {
  const FreeBody body = body_of({1, 2, 3}, {0.01, 1, 0.01});
  EXPECT_THAT(error_of(body, "lie-euler", {.step = 0.1}, -20), testing::HasSubstr("at -20 s"));
  EXPECT_EQ(error_of(body, "rkmk4", {.step = 0.01}, 20), "");
}

// The angle of a known rotation about an axis that no body axis is.
TEST(VisibleError, IsTheAngleBetweenTheAttitudes) {
  const FreeBody body = body_of({1, 2, 3}, {0.3, 1, 0.2});
  Sample sample = ExactMotion(body).at(5);
  const Eigen::Matrix3d X = sample.X;
  for (const auto& [degrees, text] :
       {std::pair(0.99, ""), {1.5, "1.5"}, {90.0, "90"}, {180.0, "180"}}) {
    sample.X =
        Eigen::AngleAxisd(degrees * std::numbers::pi / 180, Eigen::Vector3d(1, 2, 2) / 3) * X;
    const std::string error = visible_error(body, find_method("rk4"), sample);
    EXPECT_EQ(error.empty(), degrees < 1) << error;
    EXPECT_THAT(error,
                testing::HasSubstr(*text == '\0' ? "" : "off by " + std::string(text) + " "));
  }
}

TEST(VisibleError, IsNotClaimedWhereTheClosedFormIsUnsureOrMissing) {
  const FreeBody fast = body_of({1, 2, 3}, {1e9, 1e8, 1e8});
  const Sample turned{1e6, Eigen::Matrix3d::Identity(), fast.omega()};
  EXPECT_EQ(visible_error(fast, find_method("rk4"), turned), "");
}

}  // namespace
}  // namespace twrench::motion
