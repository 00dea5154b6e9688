#include "math/elementary.h"

#include <gtest/gtest.h>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>
#include <random>

namespace twrench::elementary {
namespace {

using Real = boost::multiprecision::cpp_bin_float_50;
constexpr double eps = std::numeric_limits<double>::epsilon();

TEST(SincosQuarterTurns, IsAccurateAtAnyAngle) {
  std::mt19937_64 random(20250711);
  std::uniform_real_distribution<double> sign_and_size(-1, 1);
  for (const double largest : {1e-9, 0.5, 1.0, 4.0, 1e3, 1e9, 1e15}) {
    for (int n = 0; n < 200; ++n) {
      const double w = largest * sign_and_size(random);
      const Real turns = Real(w) / 4,
                 angle = (turns - round(turns)) * 2 * boost::math::constants::pi<Real>();
      const auto [s, c] = sincos_quarter_turns(w);
      EXPECT_NEAR(s, static_cast<double>(sin(angle)), eps) << w;
      EXPECT_NEAR(c, static_cast<double>(cos(angle)), eps) << w;
    }
  }
}

TEST(SincosQuarterTurns, IsExactAtWholeQuarterTurns) {
  for (const double turns : {0.0, 1.0, -3.0, 1e6, 0x1p48}) {
    EXPECT_EQ(sincos_quarter_turns(4 * turns).cos, 1);
    EXPECT_EQ(sincos_quarter_turns(4 * turns + 1).sin, 1);
    EXPECT_EQ(sincos_quarter_turns(4 * turns + 2).cos, -1);
    EXPECT_EQ(sincos_quarter_turns(4 * turns + 3).sin, -1);
    EXPECT_EQ(sincos_quarter_turns(4 * turns + 3).cos, 0);
  }
}

TEST(SincosQuarterTurns, IsOfTheAngleZeroWhereNoFractionIsLeft) {
  for (const double w : {0x1p51, -1e300, std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(sincos_quarter_turns(w).sin, 0);
    EXPECT_EQ(sincos_quarter_turns(w).cos, 1);
  }
}

TEST(ExpMinus, IsAccurate) {
  for (double x = 0; x < 690; x += 0.0711) {
    EXPECT_NEAR(static_cast<double>(exp_minus(x) / exp(-Real(x))), 1, eps) << x;
  }
  EXPECT_EQ(exp_minus(0), 1);
}

TEST(ExpMinus, DoesNotUnderflow) {
  EXPECT_GT(exp_minus(690), 1e-300);
  EXPECT_EQ(exp_minus(1e300), exp_minus(690));
  EXPECT_EQ(exp_minus(std::numeric_limits<double>::infinity()), exp_minus(690));
}

}  // namespace
}  // namespace twrench::elementary
