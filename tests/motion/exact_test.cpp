#include <gtest/gtest.h>
#include <twrench/math/so3.h>
#include <twrench/motion/exact.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

#include "motion/random_bodies.h"
#include "motion/reference.h"
#include "motion/taylor_motion.h"

namespace twrench::motion {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Kind = ExactMotion::Kind;

ExactMotion exact(const Vector3d& moments, const Vector3d& omega) {
  return ExactMotion(FreeBody(moments.asDiagonal(), omega));
}

/// Returns the rounding of an angle after a rotation by |omega| t, relative to that of an angle of
/// 1 rad.
double turned(const Vector3d& omega, double t) { return std::max(1.0, omega.norm() * std::abs(t)); }

/// About ten roundings: a fiftieth of the promised 1e-13 and twice the largest observed error.
constexpr double tight = 2e-15;

template <typename Reference>
void expect_agrees(const Vector3d& moments, const Vector3d& omega, double t, Reference reference) {
  SCOPED_TRACE(testing::Message() << "moments " << moments.transpose() << " omega "
                                  << omega.transpose() << " t " << t);
  reference.advance_to(t);
  const Sample sample = exact(moments, omega).at(t);
  const double bound = tight * turned(omega, t);
  EXPECT_EQ(sample.t, t);
  EXPECT_LT((sample.X - reference.X()).norm(), bound);
  EXPECT_LT((sample.omega - reference.omega()).norm(), bound * omega.norm());
}

// A long double is fast, but has more digits than a double only on some processors, such as x86.
using Quad = boost::multiprecision::cpp_bin_float_quad;
constexpr bool long_double_is_wide = std::numeric_limits<long double>::digits >= 64;
using Wide = TaylorMotion<std::conditional_t<long_double_is_wide, long double, Quad>, 22>;
using Wider = TaylorMotion<Quad, 36>;

TEST(ExactMotion, AgreesWithEveryReference) {
  for (const ReferenceCase& c : reference_cases()) {
    const ExactMotion motion(c.body);
    for (const Sample& known : c.samples) {
      SCOPED_TRACE(testing::Message() << c.name << " at " << known.t);
      const Sample sample = motion.at(known.t);
      EXPECT_LT((sample.X - known.X).norm(), tight * turned(c.omega0, known.t));
      EXPECT_LT((sample.omega - known.omega).norm(), tight * turned(c.omega0, known.t));
    }
  }
}

TEST(ExactMotion, AgreesWithTaylorSeriesForRandomBodies) {
  RandomBodies random;
  for (int n = 0; n < 1500; ++n) {
    const Vector3d moments = random.moments(), omega = random.omega();
    expect_agrees(moments, omega, random.between(-40, 40) / omega.norm(), Wide(moments, omega));
  }
}

TEST(ExactMotion, AgreesWithTaylorSeriesAfterAThousandTurns) {
  RandomBodies random;
  for (int n = 0; n < 10; ++n) {
    const Vector3d moments = random.moments(), omega = random.omega();
    expect_agrees(moments, omega, random.between(-1, 1) * 1e4 / omega.norm(), Wide(moments, omega));
  }
}

struct Boundary {
  const char* name;
  Vector3d (*moments)(double offset);
  Vector3d (*omega)(double offset);
};

void PrintTo(const Boundary& boundary, std::ostream* out) { *out << boundary.name; }

/// Each family crosses a boundary between cases at offset zero.
class AcrossBoundaries : public testing::TestWithParam<Boundary> {};

TEST_P(AcrossBoundaries, AgreesWithTaylorSeries) {
  for (const double offset : {0.1, 1e-3, 1e-6, 1e-9, 1e-12, 1e-15, 0.0}) {
    for (const double side : {1.0, -1.0}) {
      const Vector3d moments = GetParam().moments(side * offset);
      const Vector3d omega = GetParam().omega(side * offset);
      const double t = side * 30 / omega.norm();
      expect_agrees(moments, omega, t, Wider(moments, omega));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    , AcrossBoundaries,
    testing::Values(
        Boundary{"separatrix", [](double) { return Vector3d(1, 4, 6); },
                 [](double d) { return Vector3d(2 + d, 0.7, 1); }},
        Boundary{"separatrix_unequal", [](double) { return Vector3d(3.7, 1.1, 2.3); },
                 [](double d) { return Vector3d(1 + d, -std::sqrt(3.7 * 1.4 / 1.1 / 1.2), -0.1); }},
        Boundary{"intermediate_axis", [](double) { return Vector3d(1, 2, 3); },
                 [](double d) { return Vector3d(d, 1, 0); }},
        Boundary{"intermediate_axis_other_side", [](double) { return Vector3d(2, 3, 1); },
                 [](double d) { return Vector3d(-1, d, 0.1 * d); }},
        Boundary{"least_axis", [](double) { return Vector3d(1, 2, 3); },
                 [](double d) { return Vector3d(1, d, -d / 3); }},
        Boundary{"greatest_axis", [](double) { return Vector3d(1, 2, 3); },
                 [](double d) { return Vector3d(d / 3, d, -1); }},
        Boundary{"prolate", [](double d) { return Vector3d(1, 2, 2 + d); },
                 [](double) { return Vector3d(1, 0.3, -0.2); }},
        Boundary{"oblate", [](double d) { return Vector3d(2 + d, 2, 3); },
                 [](double) { return Vector3d(0.4, -0.1, 1); }},
        Boundary{"oblate_turned_in_its_plane", [](double d) { return Vector3d(2 + d, 3, 2); },
                 [](double d) { return Vector3d(0.4, d, 0.2); }},
        Boundary{"sphere", [](double d) { return Vector3d(1 + d, 1, 1 - d / 2); },
                 [](double) { return Vector3d(0.4, 0.1, 0.2); }}),
    [](const auto& boundary) { return boundary.param.name; });

TEST(ExactMotion, TellsTheKindsApart) {
  EXPECT_EQ(exact({1, 2, 3}, {1, 0.1, 0.1}).kind(), Kind::about_least);
  EXPECT_EQ(exact({1, 2, 3}, {0.1, 0.1, 1}).kind(), Kind::about_greatest);
  EXPECT_EQ(exact({1, 4, 6}, {2, 0, 1}).kind(), Kind::separatrix);
  EXPECT_EQ(exact({1, 2, 3}, {0, 0, 0}).kind(), Kind::steady);
  EXPECT_EQ(exact({1, 1, 1}, {1, 2, 3}).kind(), Kind::steady);
  EXPECT_EQ(exact({2, 2, 3}, {1, 2, 0}).kind(), Kind::steady);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_EQ(exact({1, 2, 3}, -Vector3d::Unit(axis)).kind(), Kind::steady);
  }
}

TEST(ExactMotion, SteadySpinIsOneExponential) {
  const std::vector<std::pair<Vector3d, Vector3d>> steady = {{{1, 2, 3}, {0, -0.7, 0}},
                                                             {{5, 5, 5}, {1, 2, 3}},
                                                             {{2, 3, 2}, {1, 0, 2}},
                                                             {{1, 2, 3}, {0, 0, 0}}};
  for (const auto& [moments, omega] : steady) {
    for (const double t : {-3.0, 0.0, 1e3}) {
      const Sample sample = exact(moments, omega).at(t);
      EXPECT_LT((sample.X - so3::exp(t * omega)).norm(), tight * turned(omega, t));
      EXPECT_EQ(sample.omega, omega);
    }
  }
}

TEST(ExactMotion, OnTheSeparatrixTheBodyComesToRestOnItsIntermediateAxis) {
  const ExactMotion motion = exact({1, 4, 6}, {2, 0, 1});
  const double speed = Vector3d(2, 0, 6).norm() / 4;  // G / I_2
  const Sample late = motion.at(1e6), early = motion.at(-1e6);
  EXPECT_LT((late.omega.cwiseAbs() - Vector3d(0, speed, 0)).norm(), 1e-15);
  EXPECT_LT((late.omega + early.omega).norm(), 1e-15);
  const Sample later = motion.at(1e6 + 1);
  EXPECT_LT((later.X - late.X * so3::exp(late.omega)).norm(), 1e-9);  // rounding of 1e6 radians
}

TEST(ExactMotion, BeginsAtTheIdentity) {
  RandomBodies random;
  for (int n = 0; n < 300; ++n) {
    const Vector3d omega = random.omega();
    const Sample sample = exact(random.moments(), omega).at(0);
    EXPECT_LT((sample.X - Matrix3d::Identity()).norm(), tight);
    EXPECT_LT((sample.omega - omega).norm(), tight * omega.norm());
  }
}

TEST(ExactMotion, ConservesWhatIsConserved) {
  RandomBodies random;
  for (int n = 0; n < 500; ++n) {
    const Vector3d moments = random.moments(), omega = random.omega();
    const FreeBody body(moments.asDiagonal(), omega);
    const Sample s = ExactMotion(body).at(random.between(-1e6, 1e6));
    const Vector3d m = body.inertia() * s.omega;
    const double G = body.momentum().norm();
    EXPECT_LT((s.X.transpose() * s.X - Matrix3d::Identity()).norm(), tight);
    EXPECT_NEAR(s.X.determinant(), 1, tight);
    EXPECT_NEAR(m.norm(), G, tight * G);
    EXPECT_LT((s.X * m - body.momentum()).norm(), tight * G);
    const double energy = omega.dot(body.momentum());
    EXPECT_NEAR(s.omega.dot(m), energy, 3 * tight * energy);
  }
}

TEST(ExactMotion, GoesOnFromWhereItWas) {
  RandomBodies random;
  for (int n = 0; n < 500; ++n) {
    const Vector3d moments = random.moments(), omega = random.omega();
    const double t1 = random.between(-10, 10) / omega.norm();
    const double t2 = random.between(-10, 10) / omega.norm();
    const ExactMotion motion = exact(moments, omega);
    const Sample first = motion.at(t1);
    const Sample second = exact(moments, first.omega).at(t2);
    // The motion amplifies the rounding of omega(t1), so this is far less accurate than a sample.
    EXPECT_LT((motion.at(t1 + t2).X - first.X * second.X).norm(), 1e-12);
  }
}

TEST(ExactMotion, DoesNotDependOnHowTheAxesAreNamed) {
  const Vector3d moments(1.3, 2.1, 2.9);
  const double t = 11;
  for (const Vector3d& omega : {Vector3d(0.9, 0.4, 0.1), Vector3d(0.1, 0.8, 0.7)}) {
    const Sample sample = exact(moments, omega).at(t);
    std::array<int, 3> order{0, 1, 2};
    do {
      for (int signs = 0; signs < 8; ++signs) {
        Matrix3d M = Matrix3d::Zero();  // half of them are mirror images, because omega is axial
        for (int i = 0; i < 3; ++i) {
          M(i, order[static_cast<std::size_t>(i)]) = (signs >> i) % 2 == 0 ? 1 : -1;
        }
        const double handedness = M.determinant();
        const Sample renamed = exact(M.cwiseAbs() * moments, handedness * M * omega).at(t);
        EXPECT_LT((renamed.X - M * sample.X * M.transpose()).norm(), tight * t);
        EXPECT_LT((renamed.omega - handedness * M * sample.omega).norm(), tight * t);
      }
    } while (std::ranges::next_permutation(order).found);
  }
}

TEST(ExactMotion, TakesAnInertiaThatIsNotDiagonal) {
  RandomBodies random;
  for (int n = 0; n < 300; ++n) {
    const Vector3d moments = random.moments(), omega = random.omega();
    const double t = random.between(-10, 10) / omega.norm();
    const Matrix3d R = so3::exp(random.vector());
    const Matrix3d inertia = R * moments.asDiagonal() * R.transpose();
    const Matrix3d symmetric = 0.5 * (inertia + inertia.transpose());
    const Sample sample = exact(moments, omega).at(t);
    const Sample rotated = ExactMotion(FreeBody(symmetric, R * omega)).at(t);
    EXPECT_LT((rotated.X - R * sample.X * R.transpose()).norm(), 1e-12);
    EXPECT_LT((rotated.omega - R * sample.omega).norm(), 1e-12 * omega.norm());
  }
}

// Summing over parts leaves products of inertia of this size. They are below the rounding of the
// moments.
TEST(ExactMotion, SpinsAboutTheEquatorOfASymmetricBodyWhoseAxesAreTurnedByLessThanARounding) {
  Matrix3d inertia = Vector3d(64, 1, 64).asDiagonal();
  inertia(0, 1) = inertia(1, 0) = -7e-15;
  const Vector3d omega(1.25, 0, 0);
  const Sample sample = ExactMotion(FreeBody(inertia, omega)).at(2);
  EXPECT_LT((sample.X - so3::exp(2 * omega)).norm(), tight);
  EXPECT_EQ(sample.omega, omega);
}

// An underflow of the product of two small differences would make the phase infinite.
TEST(ExactMotion, NothingUnderflowsOfASmallBodyThatIsNearlyASphere) {
  for (const double mass : {1e-300, 1e-44, 1.0, 1e44, 1e300}) {
    const Vector3d moments = mass * Vector3d(1, 1.000000001055, 1.0000000005274);
    for (const double off : {1e-10, 1e-100, 9.4e-133, 1e-145, 1e-160, 1e-300}) {
      const Vector3d omega(off, 0, -0.005);
      const Sample sample = exact(moments, omega).at(-26.7);
      EXPECT_LT((sample.X - so3::exp(-26.7 * omega)).norm(), tight) << mass << ' ' << off;
      EXPECT_LT((sample.omega - omega).norm(), tight * 0.005) << mass << ' ' << off;
    }
  }
}

TEST(ExactMotion, HasNoFlipsIfTwoMomentsAreNearlyEqual) {
  const auto flips = [](const Vector3d& moments) {
    return ExactMotion(FreeBody(moments.asDiagonal(), {0.3, 1, 0.2})).flips();
  };
  for (const Vector3d& moments :
       {Vector3d(2, 2 + 4e-9, 3), Vector3d(2, 2.00019, 3), Vector3d(2, 3, 3.00029)}) {
    EXPECT_FALSE(flips(moments)) << moments.transpose();
  }
  EXPECT_TRUE(flips({2, 2.00021, 3}));
  EXPECT_TRUE(flips({2, 3, 3.00031}));
}

TEST(ExactMotion, OnlyTheRatiosOfMomentsMatter) {
  const Vector3d moments(1, 2, 3), omega(0.3, 1.1, -0.4);
  const Sample sample = exact(moments, omega).at(7);
  for (const double scale : {0x1p-500, 0x1p+300}) {
    EXPECT_LT((exact(scale * moments, omega).at(7).X - sample.X).norm(), tight);
    EXPECT_LT((exact(moments, scale * omega).at(7 / scale).X - sample.X).norm(), tight);
  }
}

}  // namespace
}  // namespace twrench::motion
