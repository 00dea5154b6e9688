#include <gtest/gtest.h>
#include <twrench/motion/error.h>
#include <twrench/motion/exact.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "motion/random_bodies.h"
#include "motion/reference.h"

namespace twrench::motion {
namespace {

using Eigen::Vector3d;

ExactMotion exact_motion(const Vector3d& moments, const Vector3d& omega) {
  return ExactMotion(FreeBody(moments.asDiagonal(), omega));
}

// A list of all flips would exhaust the memory.
TEST(Flips, MoreThanCanBeListedAreRefused) {
  const ExactMotion fast = exact_motion({1, 2, 3}, {1e12, 1e11, 1});
  EXPECT_THROW(fast.flip_times(1e9), MotionError);
  EXPECT_THROW(fast.flip_times(INFINITY), OutOfRange);
  EXPECT_EQ(fast.flip_times(10 * fast.flips()->interval).size(), 10U);
}

TEST(Flips, IntervalsOfKnownBodies) {
  struct Known {
    Vector3d moments, omega;
    double interval;
  };
  // Complete integrals in 40 digits.
  for (const Known& k : {Known{{3, 5, 9}, {0, 2.0 / 5, 0.01 / 9}, 59.055443523193},
                         Known{{1, 2, 3}, {0.01, 1, 0.01}, 19.552867098634},
                         Known{{0.3, 0.35, 0.4}, {0.1, 15, 0.1}, 6.167472904670}}) {
    const auto flips = exact_motion(k.moments, k.omega).flips();
    ASSERT_TRUE(flips);
    EXPECT_NEAR(flips->interval, k.interval, 1e-12 * k.interval);
  }
}

TEST(Flips, OfTheWrench) {
  const auto flips = ExactMotion(reference_case("wrench-a").body).flips();
  ASSERT_TRUE(flips);
  EXPECT_NEAR(flips->interval, 23.630725246383427, 1e-13);
  EXPECT_NEAR(flips->first, 23.630725246383427 / 2, 1e-13);  // starts halfway between two flips
  EXPECT_NEAR(flips->asymptotic_interval, 23.618730497761169, 1e-13);
  EXPECT_GT(flips->swing, 3.0);
  EXPECT_LT(ExactMotion(reference_case("wrench-b").body).flips()->swing, 0.4);
  EXPECT_LT(ExactMotion(reference_case("wrench-c").body).flips()->swing, 0.1);
}

// The formulas in the report, evaluated with the standard library's elliptic integrals of the
// modulus.
TEST(Flips, FollowFromMomentsAndEnergy) {
  for (const ReferenceCase& reference : reference_cases()) {
    const FreeBody& body = reference.body;
    const auto flips = ExactMotion(body).flips();
    if (!flips || flips->mc < 1e-6) continue;  // there the modulus rounds to 1
    const Vector3d I = body.principal().moments;
    const Vector3d omega = body.principal().axes.transpose() * body.omega();
    const double G2 = body.momentum().squaredNorm(), T2 = body.omega().dot(body.momentum());
    const Vector3d D = Vector3d::Constant(G2) - T2 * I;
    const bool least = D[1] < 0;
    const double own = least ? I[1] - I[0] : I[2] - I[1], far = least ? -D[2] : D[0];
    const double lambda = std::sqrt(own * far / I.prod());
    const double mc = std::abs(D[1]) * (I[2] - I[0]) / (far * own);
    const double A = std::sqrt((least ? D[0] : -D[2]) / (I[1] * own));
    const double k = std::sqrt(1 - mc), sine = std::min(1.0, std::abs(omega[1]) / A);
    const double F = std::ellint_1(k, std::asin(sine));
    const bool decreases = omega[1] * omega[2] * omega[0] * (I[2] - I[0]) / I[1] < 0;
    const double first = (decreases ? F : 2 * std::comp_ellint_1(k) - F) / lambda;
    EXPECT_NEAR(flips->rate, lambda, 1e-9 * lambda) << reference.name;
    EXPECT_NEAR(flips->mc, mc, 1e-8) << reference.name;
    EXPECT_NEAR(flips->first, first, 1e-5 * flips->interval) << reference.name;
    EXPECT_NEAR(std::sin(flips->swing / 2), I[1] * A / std::sqrt(G2), 1e-9) << reference.name;
  }
}

TEST(Flips, AreWhereTheIntermediateComponentChangesSign) {
  RandomBodies random;
  for (int n = 0; n < 200; ++n) {
    Vector3d moments = random.moments();
    std::sort(moments.data(), moments.data() + 3);
    const Vector3d omega = random.omega();
    const ExactMotion motion = exact_motion(moments, omega);
    const double end = 60 / omega.norm();
    const std::vector<double> times = motion.flip_times(end);
    std::vector<double> bounds{0.0};
    for (const double t : times) {
      EXPECT_GT(t, bounds.back());
      EXPECT_LE(t, end);
      EXPECT_LT(std::abs(motion.at(t).omega[1]), 1e-11 * omega.norm());
      bounds.push_back(t);
    }
    bounds.push_back(end);
    // Between flips the sign is constant, and it alternates.
    double sign = std::copysign(1.0, omega[1]);
    for (std::size_t i = 0; i + 1 < bounds.size(); ++i) {
      for (const double share : {0.02, 0.5, 0.98}) {
        const double t = bounds[i] + share * (bounds[i + 1] - bounds[i]);
        EXPECT_GT(sign * motion.at(t).omega[1], 0) << moments << "\n" << omega;
      }
      sign = -sign;
    }
  }
}

TEST(Flips, TendToTheAsymptoticInterval) {
  for (const double offset : {1e-3, 1e-6, 1e-12, 1e-150}) {
    const auto flips = exact_motion({1, 2, 3}, {offset, 1, 0}).flips();
    ASSERT_TRUE(flips);
    EXPECT_NEAR(flips->asymptotic_interval / flips->interval, 1, offset * offset + 1e-15);
    EXPECT_NEAR(flips->swing, std::numbers::pi, 3 * offset + 1e-15);
  }
}

TEST(Flips, OnTheSeparatrixOneAtMost) {
  const ExactMotion before = exact_motion({1, 4, 6}, {2, -0.5, 1}),
                    after = exact_motion({1, 4, 6}, {2, 0.5, 1});
  ASSERT_TRUE(before.flips() && after.flips());
  EXPECT_EQ(before.flips()->interval, INFINITY);
  EXPECT_EQ(before.flips()->asymptotic_interval, INFINITY);
  const auto times = std::max(before.flip_times(1e9), after.flip_times(1e9));
  const auto none = std::min(before.flip_times(1e9), after.flip_times(1e9));
  EXPECT_EQ(times.size(), 1U);
  EXPECT_TRUE(none.empty());
}

TEST(Flips, NoneWithoutAnIntermediateAxisOrWithoutMotionAboutIt) {
  EXPECT_FALSE(exact_motion({1, 2, 2}, {1, 0.3, -0.2}).flips());
  EXPECT_FALSE(exact_motion({1, 1, 1}, {1, 0.3, -0.2}).flips());
  EXPECT_FALSE(exact_motion({1, 2, 3}, {0, 1, 0}).flips());
  EXPECT_FALSE(exact_motion({1, 2, 3}, {0, 0, 0}).flips());
  EXPECT_TRUE(exact_motion({1, 2, 3}, {0, 0, 0}).flip_times(100).empty());
}

TEST(NutationPeriod, IsTwoFlipsOrOneTurnOfTheMomentumAboutTheAxisOfSymmetry) {
  const ExactMotion flipping = exact_motion({1, 2, 3}, {0.1, 1, 0});
  EXPECT_DOUBLE_EQ(*flipping.nutation_period(), 2 * flipping.flips()->interval);
  // omega_1 (I_2 - I_1) / I_2 = 0.5 rad/s
  EXPECT_DOUBLE_EQ(*exact_motion({1, 2, 2}, {1, 0.3, -0.2}).nutation_period(),
                   4 * std::numbers::pi);
  EXPECT_FALSE(exact_motion({1, 2, 3}, {0, 1, 0}).nutation_period());
  EXPECT_FALSE(exact_motion({1, 1, 1}, {1, 0.3, -0.2}).nutation_period());
}

}  // namespace
}  // namespace twrench::motion
