#include "check/verdict/conditioning.h"

#include <gtest/gtest.h>
#include <twrench/motion/stability.h>

#include <Eigen/SVD>
#include <cmath>

#include "check/recordings.h"

namespace twrench::check {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector3d;

// About the intermediate axis the linearised motion is known: w1' = a w3, w3' = b w1, a b = rate^2.
TEST(ErrorGrowth, AboutTheIntermediateAxisIsThatOfTheLinearisedMotion) {
  const double speed = 1, a = (moments[1] - moments[2]) / moments[0] * speed,
               b = (moments[0] - moments[1]) / moments[2] * speed, rate = std::sqrt(a * b);
  const motion::FreeBody body(moments.asDiagonal(), Vector3d(0, speed, 0));
  const std::vector<double> times{0, 5, 20, 50};
  const std::vector<Growth> growth = error_growth(body, times, 1e-16);
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double c = std::cosh(rate * times[i]), s = std::sinh(rate * times[i]);
    Matrix2d linear;
    linear << c, a / rate * s, b / rate * s, c;
    const double largest = Eigen::JacobiSVD<Matrix2d>(linear).singularValues()[0];
    EXPECT_NEAR(growth[i].rates, largest, 1e-3 * largest) << times[i];
  }
}

// On a sphere, an error of omega remains constant, and the attitude is off by this error times t.
TEST(ErrorGrowth, OfASphereIsOneForRatesAndTForTheAttitude) {
  const motion::FreeBody body(Eigen::Matrix3d::Identity(), Vector3d(0.1, 0.2, 0.3));
  const std::vector<double> times{1, 10, 100};
  const std::vector<Growth> growth = error_growth(body, times, 1e-16);
  for (std::size_t i = 0; i < times.size(); ++i) {
    EXPECT_NEAR(growth[i].rates, 1, 1e-8);
    EXPECT_NEAR(growth[i].attitude, times[i], 1e-6 * times[i]);
  }
}

// If the initial error decides on which side of the separatrix the body is, it grows to the size of
// the motion and no further.
TEST(ErrorGrowth, OfALargeErrorDoesNotPassTheMotionItself) {
  const motion::FreeBody body(moments.asDiagonal(), Vector3d(1e-9, 1, 1e-9));
  const std::vector<double> times{200};
  const Growth growth = error_growth(body, times, 1e-6).back();
  EXPECT_GT(growth.rates * 1e-6, 0.1);
  EXPECT_LT(growth.rates * 1e-6, 2);
}

}  // namespace
}  // namespace twrench::check
