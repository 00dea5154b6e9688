#include "check/reading.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <twrench/math/so3.h>

#include <Eigen/Geometry>

#include "check/recordings.h"

namespace twrench::check {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

/// A file of time, quaternion and rates, as `write` makes them of a row: four and three numbers.
class QuaternionFile {
 public:
  template <typename Write>
  explicit QuaternionFile(const Write& write) {
    std::string text = "t,a,b,c,d,wx,wy,wz\n";
    for (const Row& row : exact_rows(301, 0.05)) {
      const auto [q, w] = write(row, Quaterniond(row.X));
      text += fmt::format("{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g}\n",
                          row.t, q[0], q[1], q[2], q[3], w[0], w[1], w[2]);
    }
    system::write_file_atomically(path(), text);
  }

  std::filesystem::path path() const { return folder_ / "file.csv"; }

  /// The only reading that fits, where it is read as w, x, y, z, space from body, rad/s of the
  /// body.
  std::optional<Reading> fitting() const { return fitting_variant(path(), inertia, as_told()); }

  static Convention as_told() {
    Convention told;
    told.columns = {{"t", "t"},  {"qw", "a"},  {"qx", "b"},  {"qy", "c"},
                    {"qz", "d"}, {"wx", "wx"}, {"wy", "wy"}, {"wz", "wz"}};
    told.unit = Angle::radians;
    return told;
  }

 private:
  ScratchFolder folder_;
};

using Written = std::pair<Eigen::Vector4d, Vector3d>;

Eigen::Vector4d wxyz(const Quaterniond& q) { return {q.w(), q.x(), q.y(), q.z()}; }

Written as_told(const Row& row, const Quaterniond& q) { return {wxyz(q), row.omega}; }

TEST(Misfit, IsNearZeroOfWhatFollowsTheMotion) {
  const std::vector<Row> rows = exact_rows(128, 0.05);
  for (const bool rates : {true, false}) {
    const Misfit found = misfit(inertia, rows, rates, true);
    EXPECT_LT(*found.attitude, 1e-9);
    EXPECT_TRUE(found.fits());
  }
}

TEST(Misfit, IsLargeOfAnotherBody) {
  const std::vector<Row> rows = exact_rows(128, 0.05);
  const Matrix3d other = Vector3d(3, 2, 4).asDiagonal();
  EXPECT_FALSE(misfit(other, rows, true, false).fits());
  EXPECT_FALSE(misfit(other, rows, false, true).fits());
}

TEST(Misfit, SaysNothingOfASteadyMotion) {
  const motion::ExactMotion steady({inertia, Vector3d(0, 0, 1)});
  const auto rows = rows_of([&](double t) { return steady.at(t); }, 128, 0.05);
  EXPECT_FALSE(misfit(inertia, rows, true, false).rates);
  EXPECT_FALSE(misfit(inertia, rows, false, true).attitude);
}

// Constant rates, where Euler's equations change them.
TEST(Misfit, IsLargeWhereWhatShouldChangeDoesNot) {
  std::vector<Row> rows = exact_rows(128, 0.05);
  for (Row& row : rows) row.omega = omega;
  const Misfit found = misfit(inertia, rows, true, false);
  EXPECT_FALSE(found.fits());
  EXPECT_TRUE(found.constant_rates);
  EXPECT_FALSE(misfit(inertia, exact_rows(128, 0.05), true, false).constant_rates);
}

// A first-order method with a step as long as games take still follows the motion.
TEST(Misfit, ForgivesACoarseMethod) {
  std::vector<Row> rows;
  Vector3d w = omega;
  constexpr double step = 1.0 / 60;
  for (std::size_t i = 0; i < 256; ++i) {
    rows.push_back({.number = i + 1, .t = static_cast<double>(i) * step, .omega = w});
    w += step * (inertia.inverse() * (inertia * w).cross(w));
  }
  EXPECT_TRUE(misfit(inertia, rows, true, false).fits());
}

TEST(FittingVariant, IsNoneOfWhatIsRightAsItIs) {
  // Then nobody asks; nothing else fits.
  EXPECT_FALSE(QuaternionFile(as_told).fitting());
}

TEST(FittingVariant, ScalarLast) {
  const QuaternionFile file([](const Row& row, const Quaterniond& q) {
    return Written({q.x(), q.y(), q.z(), q.w()}, row.omega);
  });
  const auto fitting = file.fitting();
  ASSERT_TRUE(fitting);
  EXPECT_EQ(fitting->convention.columns.at("qw"), "d");
  EXPECT_EQ(fitting->convention.columns.at("qx"), "a");
  EXPECT_FALSE(fitting->convention.inverse);
}

TEST(FittingVariant, BodyFromSpaceInDegrees) {
  const QuaternionFile file([](const Row& row, const Quaterniond& q) {
    return Written(wxyz(q.conjugate()), in_degrees(1) * row.omega);
  });
  const auto fitting = file.fitting();
  ASSERT_TRUE(fitting);
  EXPECT_TRUE(fitting->convention.inverse);
  EXPECT_EQ(fitting->convention.unit, Angle::degrees);
  EXPECT_FALSE(fitting->convention.rates_in_space);
}

TEST(FittingVariant, RatesInSpace) {
  const QuaternionFile file(
      [](const Row& row, const Quaterniond& q) { return Written(wxyz(q), row.X * row.omega); });
  const auto fitting = file.fitting();
  ASSERT_TRUE(fitting);
  EXPECT_TRUE(fitting->convention.rates_in_space);
  EXPECT_EQ(fitting->convention.columns, QuaternionFile::as_told().columns);
}

TEST(FittingVariant, AnotherOrderOfTheMoments) {
  const QuaternionFile file(as_told);
  const Matrix3d wrong = Vector3d(moments[2], moments[0], moments[1]).asDiagonal();
  const auto fitting = fitting_variant(file.path(), wrong, QuaternionFile::as_told());
  ASSERT_TRUE(fitting);
  EXPECT_THAT(fitting->moment_order, testing::ElementsAre(1, 2, 0));
}

TEST(FittingVariant, IsNoneOfAnotherLaw) {
  const QuaternionFile file([](const Row& row, const Quaterniond& q) {
    return Written(wxyz(q), Vector3d(std::sin(row.t), std::cos(2 * row.t), 0.3));
  });
  EXPECT_FALSE(file.fitting());
}

TEST(OnlyFitting, IsNoneWhereTwoFit) {
  const Convention convention;
  const Reading good{convention, {0, 1, 2}, {0.01, {}}}, bad{convention, {0, 1, 2}, {0.9, {}}};
  EXPECT_TRUE(only_fitting({bad, good, bad}));
  EXPECT_FALSE(only_fitting({bad, good, good}));
  // Both would pass for what a coarse method makes, but one is far better.
  const Reading fair{convention, {0, 1, 2}, {0.1, {}}};
  EXPECT_TRUE(only_fitting({fair, good, bad}));
  EXPECT_FALSE(only_fitting({bad, bad}));
  EXPECT_FALSE(only_fitting({{convention, {0, 1, 2}, {}}}));
}

}  // namespace
}  // namespace twrench::check
