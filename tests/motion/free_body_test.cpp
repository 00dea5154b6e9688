#include <gtest/gtest.h>
#include <twrench/base/error.h>
#include <twrench/math/so3.h>
#include <twrench/motion/free_body.h>

#include <cmath>
#include <optional>
#include <string>
#include <type_traits>

namespace twrench::motion {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

static_assert(!std::is_default_constructible_v<FreeBody>);

/// Returns the error of type `Kind` with which the body is rejected.
template <typename Kind>
std::optional<Kind> refusal(const Matrix3d& inertia, const Vector3d& omega) {
  try {
    const FreeBody body(inertia, omega);
  } catch (const Kind& error) {
    return error;
  }
  return std::nullopt;
}

TEST(FreeBody, HoldsItsConstants) {
  const Matrix3d R = so3::exp(Vector3d(0.3, -0.2, 1));
  Matrix3d inertia = R * Vector3d(1, 2, 3).asDiagonal() * R.transpose();
  inertia = 0.5 * (inertia + inertia.transpose()).eval();
  const Vector3d omega(0.1, 1, -0.5);
  const FreeBody body(inertia, omega);
  EXPECT_EQ(body.inertia(), inertia);
  EXPECT_EQ(body.omega(), omega);
  EXPECT_EQ(body.momentum(), inertia * omega);
  EXPECT_LE((body.inverse() * inertia - Matrix3d::Identity()).norm(), 1e-15);
  EXPECT_LE((body.principal().moments - Vector3d(1, 2, 3)).norm(), 1e-14);
}

TEST(FreeBody, IsOfAnySizeThatDoublesHold) {
  for (const double unit : {1e-290, 1e-150, 1e-60, 1.0, 1e60, 1e150, 1e290}) {
    const FreeBody body(unit * Vector3d(1, 2, 4).asDiagonal(), {0.1, 0.2, 0.3});
    EXPECT_LE((body.inverse() * body.inertia() - Matrix3d::Identity()).norm(), 1e-15) << unit;
  }
}

TEST(FreeBody, WithAMomentThatIsNotPositiveCannotBeMade) {
  for (const double moment : {0.0, -1.0, -1e-300}) {
    for (int axis = 0; axis < 3; ++axis) {
      Vector3d moments(1, 2, 3);
      moments[axis] = moment;
      const auto error = refusal<OutOfRange>(moments.asDiagonal(), Vector3d::UnitX());
      ASSERT_TRUE(error) << moments;
      EXPECT_EQ(error->quantity(), "inertia");
      EXPECT_EQ(error->value(), moment);
      EXPECT_EQ(error->least(), 0);
    }
  }
  Matrix3d indefinite = Matrix3d::Identity();  // with moments -1, 1 and 3
  indefinite(0, 1) = indefinite(1, 0) = 2;
  const auto error = refusal<OutOfRange>(indefinite, Vector3d::UnitX());
  ASSERT_TRUE(error);
  EXPECT_NEAR(error->value(), -1, 1e-14);
}

TEST(FreeBody, OfAnInertiaThatIsNotSymmetricCannotBeMade) {
  Matrix3d inertia = Vector3d(1, 2, 3).asDiagonal();
  inertia(1, 0) = 1e-9;
  const auto error = refusal<InvalidArgument>(inertia, Vector3d::UnitX());
  ASSERT_TRUE(error);
  EXPECT_EQ(error->quantity(), "inertia");
  EXPECT_NE(std::string(error->what()).find("symmetric"), std::string::npos) << error->what();
  inertia(1, 0) = 1e-16;
  EXPECT_FALSE(refusal<InvalidArgument>(inertia, Vector3d::UnitX())) << "that is round-off";
}

TEST(FreeBody, OfWhatIsNotFiniteCannotBeMade) {
  for (const double bad : {NAN, INFINITY, -INFINITY}) {
    for (int i = 0; i < 9; ++i) {
      Matrix3d inertia = Matrix3d::Identity();
      inertia(i / 3, i % 3) = bad;
      const auto error = refusal<InvalidArgument>(inertia, Vector3d::UnitX());
      ASSERT_TRUE(error) << inertia;
      EXPECT_EQ(error->quantity(), "inertia");
    }
    for (int i = 0; i < 3; ++i) {
      Vector3d omega = Vector3d::Zero();
      omega[i] = bad;
      const auto error = refusal<OutOfRange>(Matrix3d::Identity(), omega);
      ASSERT_TRUE(error) << omega;
      EXPECT_EQ(error->quantity(), "omega");
    }
  }
}

TEST(FreeBody, WhoseConstantsOverflowCannotBeMade) {
  const auto momentum =
      refusal<InvalidArgument>(1e200 * Matrix3d::Identity(), 1e200 * Vector3d::Ones());
  ASSERT_TRUE(momentum);
  EXPECT_EQ(momentum->quantity(), "omega");
  const auto energy = refusal<InvalidArgument>(Matrix3d::Identity(), 1e200 * Vector3d::Ones());
  ASSERT_TRUE(energy);
  EXPECT_EQ(energy->quantity(), "omega");
  const auto inverse = refusal<InvalidArgument>(1e-310 * Matrix3d::Identity(), Vector3d::Zero());
  ASSERT_TRUE(inverse);
  EXPECT_EQ(inverse->quantity(), "inertia");
}

}  // namespace
}  // namespace twrench::motion
