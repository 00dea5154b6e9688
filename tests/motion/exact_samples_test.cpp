#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <twrench/base/error.h>
#include <twrench/motion/exact.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "motion/bodies_of_every_kind.h"
#include "motion/reference.h"

namespace twrench::motion {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

FreeBody body_of(const BodyOfAKind& b) { return FreeBody(b.moments.asDiagonal(), b.omega); }

/// Returns unordered times of both signs, from the start to where the angle has no digits left.
std::vector<double> times_of_every_size(const Vector3d& omega) {
  const double unit = omega.norm() > 0 ? 1 / omega.norm() : 1;
  std::vector<double> times{0, 1e300, -1e300, -0.0};
  for (int n = 0; n < 150; ++n) {
    const double size = std::pow(10, n % 20 - 3) * (1 + 0.01 * n);
    times.push_back((n % 3 == 0 ? -size : size) * unit);
  }
  return times;
}

/// The two arrays of at().
struct Arrays {
  std::vector<double> X, omega;

  Arrays(const ExactMotion& motion, std::span<const double> times, unsigned threads)
      : X(9 * times.size()), omega(3 * times.size()) {
    motion.at(times, X, omega, threads);
  }
  bool operator==(const Arrays&) const = default;
};

void expect_same_bits(const Sample& found, const Sample& alone) {
  EXPECT_EQ(found.t, alone.t);
  EXPECT_EQ(found.X, alone.X) << alone.t;
  EXPECT_EQ(found.omega, alone.omega) << alone.t;
}

TEST(ExactSamples, HaveTheBitsOfEachAlone) {
  for (const BodyOfAKind& b : bodies_of_every_kind()) {
    SCOPED_TRACE(testing::Message() << b.moments.transpose() << " omega " << b.omega.transpose());
    const ExactMotion motion(body_of(b));
    const std::vector<double> times = times_of_every_size(b.omega);
    const std::vector<Sample> samples = motion.at(times);
    const Arrays arrays(motion, times, 1);
    ASSERT_EQ(samples.size(), times.size());
    for (std::size_t i = 0; i < times.size(); ++i) {
      const Sample alone = motion.at(times[i]);
      expect_same_bits(samples[i], alone);
      EXPECT_EQ(Matrix3d(Matrix3d(Eigen::Map<const Matrix3d>(&arrays.X[9 * i])).transpose()),
                alone.X);
      EXPECT_EQ(Vector3d(&arrays.omega[3 * i]), alone.omega);
    }
  }
}

// A partly filled vector register must give the same result.
TEST(ExactSamples, DoNotDependOnHowManyThereAreNorOnTheirPlace) {
  for (const Vector3d& omega : {Vector3d(0.01, 1, 0.02), Vector3d(1, 0.5, 0.2)}) {
    const ExactMotion motion(FreeBody(Vector3d(1, 2, 3).asDiagonal(), omega));
    const Sample alone = motion.at(17.3);
    for (std::size_t size = 1; size < 140; ++size) {
      std::vector<double> times(size, -2.5);
      for (const std::size_t place : {std::size_t{0}, size / 2, size - 1}) times[place] = 17.3;
      const std::vector<Sample> samples = motion.at(times);
      expect_same_bits(samples[0], alone);
      expect_same_bits(samples[size / 2], alone);
      expect_same_bits(samples[size - 1], alone);
    }
  }
}

TEST(ExactSamples, DoNotDependOnTheNumberOfThreads) {
  const ExactMotion motion(FreeBody(Vector3d(1, 2, 3).asDiagonal(), {0.01, 1, 0.02}));
  std::vector<double> times;
  for (int i = 0; i < 100'001; ++i) times.push_back(1e-3 * i);
  const Arrays one(motion, times, 1);
  for (const unsigned threads : {2U, 3U, 8U, all_processors}) {
    EXPECT_TRUE(Arrays(motion, times, threads) == one) << threads;
  }
}

TEST(ExactSamples, AgreeWithEveryReference) {
  for (const ReferenceCase& c : reference_cases()) {
    std::vector<double> times;
    for (const Sample& known : c.samples) times.push_back(known.t);
    const std::vector<Sample> samples = ExactMotion(c.body).at(times);
    for (std::size_t i = 0; i < times.size(); ++i) {
      const double bound = 2e-15 * std::max(1.0, c.omega0.norm() * std::abs(times[i]));
      EXPECT_LT((samples[i].X - c.samples[i].X).norm(), bound) << c.name << " at " << times[i];
      EXPECT_LT((samples[i].omega - c.samples[i].omega).norm(), bound);
    }
  }
}

/// Returns the product of two uniform rotations, with their angles computed in higher precision.
Matrix3d symmetric_motion(const Vector3d& moments, const Vector3d& omega, double t) {
  const auto turned = [t](double rate) {
    constexpr long double turn = 2 * std::numbers::pi_v<long double>;
    return static_cast<double>(std::remainder(static_cast<long double>(rate) * t, turn));
  };
  const Vector3d L = moments.cwiseProduct(omega);
  const double nutation = L[2] * (1 / moments[2] - 1 / moments[0]);
  return Eigen::AngleAxisd(turned(L.norm() / moments[0]), L.normalized()).toRotationMatrix() *
         Eigen::AngleAxisd(turned(nutation), Vector3d::UnitZ()).toRotationMatrix();
}

TEST(ExactSamples, AreAccurateAfterAMillionRadiansAndMore) {
  const Vector3d moments(2, 2, 3), omega(0.4, -0.1, 1);
  const ExactMotion motion(FreeBody(moments.asDiagonal(), omega));
  const std::vector<double> times{1e4, -1e5, 1e6, 3e6, -1e8, 1e10};
  for (const Sample& s : motion.at(times)) {
    const double turned = omega.norm() * std::abs(s.t);
    EXPECT_LT((s.X - symmetric_motion(moments, omega, s.t)).norm(), 4e-15 * turned) << s.t;
  }
}

TEST(ExactSamples, AreRotationsAtAnyTime) {
  for (const BodyOfAKind& b : bodies_of_every_kind()) {
    for (const Sample& s : ExactMotion(body_of(b)).at(times_of_every_size(b.omega))) {
      EXPECT_LT((s.X.transpose() * s.X - Matrix3d::Identity()).norm(), 4e-15)
          << b.moments.transpose() << " omega " << b.omega.transpose() << " t " << s.t;
    }
  }
}

TEST(ExactSamples, RefuseArraysOfTheWrongSizeAndTimesThatAreNotFinite) {
  const ExactMotion motion(FreeBody(Vector3d(1, 2, 3).asDiagonal(), {0.01, 1, 0.02}));
  std::vector<double> times{0, 1, 2}, X(27, 7.0), omega(9, 7.0);
  const auto message = [&](std::size_t X_size, std::size_t omega_size) -> std::string {
    try {
      motion.at(times, std::span(X).first(X_size), std::span(omega).first(omega_size));
    } catch (const InvalidArgument& refused) {
      return refused.what();
    }
    return "";
  };
  EXPECT_EQ(message(26, 9), "X: has 26 numbers, but 3 samples take 27");
  EXPECT_EQ(message(27, 8), "omega: has 8 numbers, but 3 samples take 9");
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    times[2] = bad;
    EXPECT_THAT(message(27, 9), testing::HasSubstr("times[2]: is "));
    EXPECT_THROW(motion.at(times), OutOfRange);
    EXPECT_THROW(motion.at(bad), OutOfRange);
  }
  EXPECT_THAT(X, testing::Each(7.0));
  EXPECT_THAT(omega, testing::Each(7.0));
  EXPECT_TRUE(motion.at(std::span<const double>()).empty());
}

}  // namespace
}  // namespace twrench::motion
