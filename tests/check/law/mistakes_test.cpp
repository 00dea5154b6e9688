#include "check/law/mistakes.h"

#include <gmock/gmock.h>
#include <twrench/motion/exact.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/enumeration.h"
#include "check/law/attitude_rates.h"
#include "check/law/candidates.h"
#include "check/recordings.h"
#include "scene_dice.h"

namespace twrench::check {
namespace {

using recording::Row;

using Eigen::Vector3d;
using testing::IsEmpty;
using testing::SizeIs;

constexpr RelativeNoise no_noise{0, 0};

TEST(Law, IsThatOfAFreeBodyByDefault) {
  const motion::Sample exact = motion::ExactMotion(tumbling_body()).at(1);
  const State start{omega, Eigen::Quaterniond::Identity()};
  const State end = advanced({.inertia = inertia}, start, 1, 0.02);
  EXPECT_LT((end.omega - exact.omega).norm(), 1e-9);
  EXPECT_LT((end.X.toRotationMatrix() - exact.X).norm(), 1e-9);
}

TEST(WrongLaws, AreNoneOfTheRightMotion) {
  const WrongLaws found = wrong_laws(inertia, exact_rows(), RowParts::both, no_noise);
  EXPECT_LT(found.rates_miss, 1e-8);
  EXPECT_LT(found.attitude_miss, 1e-8);
  EXPECT_THAT(found.of_rates, IsEmpty());
  EXPECT_THAT(found.of_attitude, IsEmpty());
}

/// Rows of a law, each `step` s after the one before.
std::vector<Row> rows_of_law(const Law& law, std::size_t count, double step) {
  State state{omega, Eigen::Quaterniond::Identity()};
  std::vector<Row> rows;
  for (std::size_t i = 0; i < count; ++i) {
    rows.push_back({.number = i + 1,
                    .t = static_cast<double>(i) * step,
                    .omega = state.omega,
                    .X = state.X.toRotationMatrix()});
    state = advanced(law, state, step, 0.005);
  }
  return rows;
}

TEST(WrongLaws, HaveTheirNumbers) {
  Law law{.inertia = inertia};
  law.body_torque = Vector3d(0.02, -0.01, 0.03);
  law.attitude_factor = 2;
  const WrongLaws found =
      wrong_laws(inertia, rows_of_law(law, 200, 0.05), RowParts::both, no_noise);
  ASSERT_THAT(found.of_rates, SizeIs(1));
  EXPECT_EQ(found.of_rates[0].mistake, Mistake::body_torque);
  EXPECT_LT((found.of_rates[0].law.body_torque - law.body_torque).norm(), 1e-8);
  ASSERT_THAT(found.of_attitude, SizeIs(1));
  EXPECT_EQ(found.of_attitude[0].mistake, Mistake::attitude_factor);
  EXPECT_EQ(found.of_attitude[0].value[0], 2);
  EXPECT_EQ(found.of_attitude[0].free_numbers, 0);
}

// The rates of these attitudes are those of a free body in the axes of space, not of the body.
TEST(WrongLaws, OfAttitudesAloneHaveSwappedFactors) {
  std::vector<Row> rows =
      rows_of_law({.inertia = inertia, .kinematics = Kinematics::space_rates}, 200, 0.05);
  for (Row& row : rows) row.omega = (row.X.transpose() * row.omega).eval();
  const WrongLaws found = wrong_laws(inertia, rows, RowParts::attitude, no_noise);
  ASSERT_THAT(found.of_rates, SizeIs(1));
  EXPECT_EQ(found.of_rates[0].mistake, Mistake::swapped_factors);
}

// Only the first tenth of these rows is at the limit: later the body turns as a free one.
TEST(WrongLaws, OfFewRowsAreFound) {
  Law law{.inertia = inertia};
  law.speed_limit = 0.995 * omega.norm();
  const std::vector<Row> rows = rows_of_law(law, 400, 0.05);
  const WrongLaws found = wrong_laws(inertia, rows, RowParts::both, no_noise);
  ASSERT_THAT(found.of_rates, SizeIs(1));
  EXPECT_EQ(found.of_rates[0].mistake, Mistake::speed_limit);
  EXPECT_NEAR(found.of_rates[0].value[0], law.speed_limit, 1e-6);
}

/// Adds independent errors to the rates, of this standard deviation relative to the first ones.
void add_noise(std::vector<Row>& rows, double size) {
  SceneDice dice(1, 1);
  for (Row& row : rows) row.omega += std::sqrt(3) * size * omega.norm() * dice.vector(-1, 1);
}

// For this body, which is almost symmetric, other moments only change how fast the rates turn.
TEST(WrongLaws, ThatNoiseHidesFromEachOtherAreAllFound) {
  const Eigen::Matrix3d right = Vector3d(3, 2.2, 2.19).asDiagonal();
  Law law{.inertia = Vector3d(3.3, 2.2, 2.19).asDiagonal()};
  std::vector<Row> rows = rows_of_law(law, 300, 0.05);
  constexpr double size = 2e-3;
  add_noise(rows, size);
  const WrongLaws found = wrong_laws(right, rows, RowParts::both, {size, size});
  const auto is_found = [&](Mistake mistake) {
    return std::ranges::any_of(found.of_rates, [=](auto& one) { return one.mistake == mistake; });
  };
  EXPECT_TRUE(is_found(Mistake::moments));
  EXPECT_TRUE(is_found(Mistake::gyroscopic_factor));
  EXPECT_FALSE(is_found(Mistake::damping));
}

// Between rows that are equally far apart, in as much noise as this, the rates of a slower law that
// turn once less fit as well.
TEST(WrongLaws, ThatTurnTheRatesFastAreNotSlowerOnes) {
  const Eigen::Matrix3d large = Vector3d(4.4, 7.5, 4.3).asDiagonal();
  std::vector<Row> rows =
      rows_of_law({.inertia = large, .division = Division::omitted}, 400, 0.025);
  constexpr double size = 2e-3;
  add_noise(rows, size);
  const WrongLaws found = wrong_laws(large, rows, RowParts::both, {size, size});
  ASSERT_THAT(found.of_rates, SizeIs(1));
  EXPECT_EQ(found.of_rates[0].mistake, Mistake::undivided);
  EXPECT_EQ(found.of_rates[0].free_numbers, 0);
}

// With these moments the rates change several times faster than the body turns. Over the two rad
// that the noise of slower motions requires, another body fits by chance.
TEST(WrongLaws, ThatChangeTheRatesFastAreNotThoseOfAnotherBody) {
  const Eigen::Matrix3d large = Vector3d(2.5, 3.5, 4.5).asDiagonal();
  std::vector<Row> rows =
      rows_of_law({.inertia = large, .division = Division::multiplied}, 400, 0.02);
  constexpr double size = 2e-3;
  add_noise(rows, size);
  const WrongLaws found = wrong_laws(large, rows, RowParts::both, {size, size});
  ASSERT_THAT(found.of_rates, SizeIs(1));
  EXPECT_EQ(found.of_rates[0].mistake, Mistake::multiplied);
  EXPECT_EQ(found.of_rates[0].free_numbers, 0);
}

// If the rates turned as slowly as the body, rows several times as far apart would do.
TEST(RatesOfAttitudes, AreRightIfTheyTurnFast) {
  const Eigen::Matrix3d large = Vector3d(2.5, 3.5, 4.5).asDiagonal();
  const std::vector<Row> rows =
      rows_of_law({.inertia = large, .division = Division::multiplied}, 800, 0.005);
  constexpr double error = 1e-4;
  const RowsWithRates found = with_rates_of_attitude(rows, error);
  ASSERT_THAT(found.rows, testing::Not(IsEmpty()));
  const double noise = found.noise * omega.norm();
  for (const Row& row : found.rows)
    ASSERT_LT((row.omega - rows[row.number - 1].omega).norm(), 2 * noise);
}

TEST(Candidates, AreAllMistakes) {
  Eigen::Matrix3d with_products = inertia;
  with_products(0, 1) = with_products(1, 0) = 0.1;
  const RowScales scales{1, 1, 0.1};
  std::vector<Candidate> all = candidates_for_rates(with_products, scales, true);
  for (const Candidate& candidate : candidates_for_attitude(scales)) all.push_back(candidate);
  for (const Mistake mistake : enumerators<Mistake>)
    EXPECT_TRUE(std::ranges::any_of(all, [=](auto& one) { return one.mistake == mistake; }))
        << enumerator_name(mistake);
}

// A fit between such rows would take minutes and mean nothing.
TEST(WrongLaws, AreNotTriedIfRowsAreFarApart) {
  const std::vector<Row> rows = exact_rows(100, 10);
  const WrongLaws found =
      wrong_laws(Vector3d(4, 3, 2).asDiagonal(), rows, RowParts::both, no_noise);
  EXPECT_THAT(found.of_rates, IsEmpty());
  EXPECT_FALSE(std::isfinite(found.rates_miss));
}

}  // namespace
}  // namespace twrench::check
