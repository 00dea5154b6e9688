#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/words.h"

namespace twrench {
namespace {

std::vector<std::string> methods() { return {"euler", "lie-euler", "rkf45", "heun", "midpoint"}; }

TEST(Nearest, ForgivesOneSlip) {
  EXPECT_EQ(nearest("eulr", methods()), "euler");
  EXPECT_EQ(nearest("eulerr", methods()), "euler");
  EXPECT_EQ(nearest("rkf46", methods()), "rkf45");
  const std::vector<std::string> equally_near{"rk4", "rkf45", "rkg45"};
  EXPECT_EQ(nearest("rk45", equally_near), "rkf45");
  EXPECT_EQ(nearest("lie_euler", methods()), "lie-euler");
}

TEST(Nearest, TakesCapitalLettersForSmallOnes) {
  EXPECT_EQ(nearest("RKF45", methods()), "rkf45");
  EXPECT_EQ(nearest("Heun", methods()), "heun");
}

TEST(Nearest, CountsASwapAsOne) { EXPECT_EQ(nearest("rfk45", methods()), "rkf45"); }

TEST(Nearest, ForgivesOneSlipInThreeLettersOfTheLongerWord) {
  const std::vector<std::string> candidate{"trails"};
  EXPECT_EQ(nearest("trial", candidate), "trails");
  EXPECT_EQ(nearest("trlia", candidate), std::nullopt);
  EXPECT_EQ(nearest("z", std::vector<std::string>{"xz"}), "xz");
}

TEST(Nearest, TakesTheNearestNotTheFirst) {
  const std::vector<std::string> candidates{"stable-x", "stable-y", "stable-z"};
  EXPECT_EQ(nearest("stabel-z", candidates), "stable-z");
  EXPECT_EQ(nearest("stable", candidates), "stable-x");
}

TEST(Nearest, OffersNothingForAnotherWord) {
  EXPECT_EQ(nearest("verlet", methods()), std::nullopt);
  EXPECT_EQ(nearest("", methods()), std::nullopt);
  EXPECT_EQ(nearest("x", std::vector<std::string>{"y"}), std::nullopt);
  EXPECT_EQ(nearest("euler", {}), std::nullopt);
}

}  // namespace
}  // namespace twrench
