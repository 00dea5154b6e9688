// Judgements of motions whose errors are known, because the test made them.
#include "check/verdict/judge.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <twrench/math/so3.h>
#include <twrench/motion/trajectory.h>

#include <atomic>
#include <functional>

#include "check/recordings.h"
#include "check/verdict/error.h"
#include "motion/reference.h"
#include "scene_dice.h"

namespace twrench::check {
namespace {

using recording::Recording;
using recording::Row;

using Eigen::Matrix3d;
using Eigen::Vector3d;

std::vector<Row> with(std::vector<Row> rows, const std::function<void(Row&)>& change) {
  for (Row& row : rows) change(row);
  return rows;
}

// Another program computed the references with 60 digits.
TEST(Judge, CannotFaultTheReferences) {
  for (const motion::ReferenceCase& reference : motion::reference_cases()) {
    std::vector<Row> rows;
    for (const motion::Sample& s : reference.samples) {
      rows.push_back({.number = rows.size() + 1, .t = s.t, .omega = s.omega, .X = s.X});
    }
    const Problem problem{.inertia = reference.body.inertia(), .omega = reference.omega0};
    const Judgement judgement = judged(rows, Parts::both, problem);
    EXPECT_TRUE(judgement.within_digits)
        << reference.name << ": " << judgement.rates->max << ", " << judgement.attitude->max;
    EXPECT_FALSE(judgement.attitude_contradicts_rates) << reference.name;
  }
}

TEST(Judge, MeasuresTheLargestComponentAndTheAngle) {
  std::vector<Row> rows = exact_rows();
  rows[100].omega += Vector3d(3e-6, -4e-6, 0);
  rows[200].X *= so3::exp(Vector3d(3e-5, -4e-5, 0));
  const Judgement judgement = judged(rows, Parts::both, tumbling_problem());
  EXPECT_NEAR(judgement.rates->max, 4e-6, 1e-13);
  EXPECT_EQ(judgement.rates->at, 10);
  EXPECT_NEAR(judgement.rates->rms, 5e-6 / std::sqrt(3 * 401), 1e-12);
  EXPECT_NEAR(judgement.attitude->max, 5e-5, 1e-12);
  EXPECT_EQ(judgement.attitude->at, 20);
  EXPECT_NEAR(judgement.attitude->rms, 5e-5 / std::sqrt(401), 1e-12);
  EXPECT_FALSE(judgement.within_digits);
}

TEST(Judge, EndsIfItIsStopped) {
  const std::atomic<bool> stop = true;
  Problem problem = tumbling_problem();
  problem.stop = &stop;
  EXPECT_THROW(judged(exact_rows(), Parts::both, problem), CheckError);
}

// Late by 1e-3 s: the same polhode, later.
TEST(Judge, TellsADelay) {
  const motion::ExactMotion exact(tumbling_body());
  const std::vector<Row> late = rows_of([&](double t) { return exact.at(t - 1e-3); }, 401, 0.1);
  Problem problem = tumbling_problem();
  problem.omega = omega;
  const Judgement judgement = judged(late, Parts::rates, problem);
  EXPECT_NEAR(judgement.parts->delay, 1e-3, 1e-9);
  EXPECT_NEAR(judgement.parts->delay_at_end, 1e-3, 1e-9);
  EXPECT_LT(judgement.parts->amplitude_rate, 1e-12);
  EXPECT_NEAR(judgement.parts->phase_rate, judgement.rates->max, 1e-12);
  EXPECT_LT(judgement.energy_error, 1e-13);
  EXPECT_FALSE(judgement.within_digits);
}

// A clock that is 1e-5 too slow, with attitudes: the motion lags, but does not turn about a wrong
// axis.
TEST(Judge, TellsADelayThatGrows) {
  const motion::ExactMotion exact(tumbling_body());
  const std::vector<Row> slow =
      rows_of([&](double t) { return exact.at(t * (1 - 1e-5)); }, 401, 0.1);
  const Judgement judgement = judged(slow, Parts::both, tumbling_problem());
  EXPECT_NEAR(judgement.parts->delay_at_end, 40e-5, 1e-9);
  EXPECT_NEAR(judgement.parts->delay_at, 40, 1e-9);
  EXPECT_LT(judgement.parts->amplitude_rate, 1e-12);
  EXPECT_LT(std::abs(judgement.parts->angle_about_l), 1e-12);
  EXPECT_LT(judgement.parts->tilt, 1e-12);
}

// The delay is still counted in full after many flips.
TEST(Judge, FollowsADelayOverWholeFlips) {
  const motion::ExactMotion exact(tumbling_body());
  const double interval = exact.flips()->interval;
  const std::vector<Row> slow = rows_of([&](double t) { return exact.at(t * 0.96); }, 4001, 0.1);
  const Judgement judgement = judged(slow, Parts::rates, tumbling_problem());
  ASSERT_GT(0.04 * 400, interval);
  EXPECT_NEAR(judgement.parts->delay_at_end, 0.04 * 400, 1e-6);
}

// The same phase on another polhode.
TEST(Judge, TellsAScale) {
  const std::vector<Row> rows = with(exact_rows(), [](Row& row) { row.omega *= 1 + 1e-6; });
  Problem problem = tumbling_problem();
  problem.omega = omega;
  const Judgement judgement = judged(rows, Parts::rates, problem);
  EXPECT_NEAR(judgement.energy_error, 2e-6, 1e-11);
  EXPECT_NEAR(*judgement.momentum_error, 1e-6, 1e-11);
  EXPECT_LT(judgement.energy_drift, 1e-13);
  EXPECT_LT(std::abs(judgement.parts->delay), 1e-11);
  EXPECT_NEAR(judgement.parts->amplitude_rate, judgement.rates->max, 1e-11);
}

TEST(Judge, TellsAnAngleAboutLFromATiltOfIt) {
  const Vector3d L = (moments.asDiagonal() * omega).normalized();
  const Vector3d across = L.unitOrthogonal();
  const auto turned = [&](const Vector3d& axis) {
    return judged(
        with(exact_rows(), [&](Row& row) { row.X = so3::exp(1e-6 * row.t * axis) * row.X; }),
        Parts::both, tumbling_problem());
  };
  const Judgement about = turned(L), tilted = turned(across);
  EXPECT_NEAR(about.parts->angle_about_l, 40e-6, 1e-9);
  EXPECT_LT(about.parts->tilt, 1e-9);
  EXPECT_LT(std::abs(tilted.parts->angle_about_l), 1e-9);
  EXPECT_NEAR(tilted.parts->tilt, 40e-6, 1e-9);
  EXPECT_NEAR(*tilted.direction_drift, 40e-6, 1e-9);
  EXPECT_LT(*about.direction_drift, 1e-9);
}

// As in a file whose attitude is relative to the surface of the Earth.
TEST(Judge, SeesThatAnAttitudeIsAgainstAFrameThatTurns) {
  const Vector3d rate(1e-5, 2e-5, -7e-5);
  const std::vector<Row> rows =
      with(exact_rows(), [&](Row& row) { row.X = so3::exp(row.t * rate) * row.X; });
  const Judgement judgement = judged(rows, Parts::both, tumbling_problem());
  EXPECT_TRUE(judgement.attitude_contradicts_rates);
  EXPECT_LT((judgement.frame_turn.rate - rate).norm(), 1e-11);
  EXPECT_GT(judgement.frame_turn.share, 0.999999);
}

// An integrator whose rates are off has an attitude that is off too.
TEST(Judge, DoesNotCallErrorsOfBothAContradiction) {
  const motion::Method& method = motion::find_method("rkmk4");
  std::vector<double> times;
  for (int i = 0; i <= 400; ++i) times.push_back(0.1 * i);
  const auto run = motion::integrate(tumbling_body(), method, {.step = 0.1}, times);
  std::vector<Row> rows;
  for (const motion::Sample& s : run.samples) {
    rows.push_back({.number = rows.size() + 1, .t = s.t, .omega = s.omega, .X = s.X});
  }
  const Judgement judgement = judged(rows, Parts::both, tumbling_problem());
  EXPECT_FALSE(judgement.within_digits);
  EXPECT_FALSE(judgement.attitude_contradicts_rates);
}

TEST(Judge, TakesASpaceFrameOfTheFilesOwn) {
  const Matrix3d frame = so3::exp(Vector3d(0.5, -1, 2));
  const std::vector<Row> rows = with(exact_rows(), [&](Row& row) { row.X = frame * row.X; });
  EXPECT_TRUE(judged(rows, Parts::both, tumbling_problem()).within_digits);
}

// The first attitude is tilted by mistake, and all others reveal it.
TEST(Judge, TakesTheFrameFromTheMomentum) {
  const Vector3d across = (moments.asDiagonal() * omega).unitOrthogonal();
  std::vector<Row> rows = exact_rows(4001, 0.01);
  rows[0].X = so3::exp(1e-3 * across) * rows[0].X;
  Problem problem = tumbling_problem();
  EXPECT_NEAR(judged(rows, Parts::both, problem).attitude->rms, 1e-3, 1e-5);
  problem.frame = FrameSource::momentum;
  EXPECT_LT(judged(rows, Parts::both, problem).attitude->rms, 2e-5);
  EXPECT_NEAR(judged(rows, Parts::both, problem).attitude->max, 1e-3, 1e-6);
}

TEST(Judge, CountsTimeFromTheFirstRow) {
  const std::vector<Row> later = exact_rows(401, 0.1, 5);
  EXPECT_TRUE(judged(later, Parts::both, tumbling_problem()).within_digits);
  Problem problem = tumbling_problem();
  problem.omega = motion::ExactMotion(tumbling_body()).at(-5).omega;
  const Judgement told = judged(later, Parts::both, problem);
  EXPECT_LT(told.rates->max, 1e-12);
  EXPECT_EQ(told.first_time, 5);
  EXPECT_EQ(clock_time(told, told.reference.start), 0);
  problem.omega = omega;
  for (const std::optional<double> at_five : {std::optional<double>(5), std::optional<double>()}) {
    problem.omega_time = at_five;
    EXPECT_TRUE(judged(later, Parts::attitude, problem).within_digits);
  }
}

TEST(Judge, AttitudesAloneTakeARateFromElsewhereOrAFit) {
  const Matrix3d frame = so3::exp(Vector3d(0.5, -1, 2));
  const std::vector<Row> rows = with(exact_rows(), [&](Row& row) { row.X = frame * row.X; });
  EXPECT_TRUE(judged(rows, Parts::attitude, tumbling_problem()).fit);
  Problem problem = tumbling_problem();
  problem.omega = omega;
  const Judgement judgement = judged(rows, Parts::attitude, problem);
  EXPECT_TRUE(judgement.within_digits);
  EXPECT_FALSE(judgement.rates);
  EXPECT_FALSE(judgement.momentum_drift);
  EXPECT_LT(judgement.energy_drift, 1e-12);
  ASSERT_EQ(judgement.flips.size(), 3U);
  for (const Flip& flip : judgement.flips) EXPECT_NEAR(*flip.found, *flip.exact, 1e-9);
  problem.omega.reset();
  problem.fit = true;
  EXPECT_LT(judged(rows, Parts::attitude, problem).attitude->max, 1e-11);
}

TEST(Judge, TellsDriftsOfTheFilesOwnNumbers) {
  std::vector<Row> rows = with(exact_rows(), [](Row& row) {
    row.omega *= 1 + 1e-5 * row.t;
    row.X(0, 0) += 1e-7;
  });
  const Judgement judgement = judged(rows, Parts::both, tumbling_problem());
  EXPECT_NEAR(judgement.energy_drift, 2 * 40e-5, 1e-6);
  EXPECT_NEAR(*judgement.momentum_drift, 40e-5, 1e-9);
  EXPECT_GT(*judgement.orthogonality_error, 1e-8);
  EXPECT_LT(*judgement.orthogonality_error, 3e-7);
}

TEST(Judge, LetsRoundedDigitsPass) {
  for (const int decimals : {4, 7, 10}) {
    const Judgement judgement = judged(exact_rows(), Parts::rates, tumbling_problem(), decimals);
    EXPECT_TRUE(judgement.within_digits) << decimals;
    EXPECT_NEAR(judgement.digits.rate, std::pow(10, -decimals), 1e-12) << decimals;
    EXPECT_GT(judgement.rates->max, 0.1 * judgement.digits.rate);
  }
}

// With six significant digits, large Euler angles have three decimals of a degree.
TEST(Judge, LetsRoundedEulerAnglesPass) {
  std::string text = "t,yaw,pitch,roll,wx,wy,wz\n";
  for (const Row& row : exact_rows()) {
    const Matrix3d& X = row.X;
    const Vector3d w = in_degrees(1) * row.omega;
    text += fmt::format("{:.1f},{:.6g},{:.6g},{:.6g},{:.9g},{:.9g},{:.9g}\n", row.t,
                        in_degrees(std::atan2(X(1, 0), X(0, 0))), in_degrees(-std::asin(X(2, 0))),
                        in_degrees(std::atan2(X(2, 1), X(2, 2))), w[0], w[1], w[2]);
  }
  const ScratchFolder folder;
  system::write_file_atomically(folder / "euler.csv", text);
  recording::Convention convention = own_names(Parts::rates);
  for (const char* name : {"yaw", "pitch", "roll"}) convention.columns[name] = name;
  convention.rate_unit = recording::RateUnit::deg_s;
  convention.sequence = "zyx";
  const Judgement judgement =
      judge(Recording(folder / "euler.csv"), convention, tumbling_problem());
  EXPECT_TRUE(judgement.within_digits) << in_degrees(judgement.attitude->max);
  EXPECT_GT(in_degrees(judgement.attitude->max), 4e-4);
  EXPECT_FALSE(judgement.attitude_contradicts_rates);
}

// Rates computed with 12 digits, turned, and printed with 17.
TEST(Judge, FindsTheDigitsThatAProgramReallyHas) {
  const Matrix3d turn = so3::exp(Vector3d(0.3, 0.2, 0.1));
  const auto round = [](double x) { return std::round(x * 1e12) / 1e12; };
  std::vector<Row> rows = with(exact_rows(), [&](Row& row) {
    row.omega = turn.transpose() * (turn * row.omega).unaryExpr(round);
  });
  const Judgement rounded = judged(rows, Parts::rates, tumbling_problem());
  EXPECT_TRUE(rounded.within_digits);
  EXPECT_NEAR(rounded.digits.rate, 1e-12, 0.3e-12);
  EXPECT_LT(rounded.digits.printed_rate, 1e-14);

  // A smooth error of the same size, as of a method, is not rounding.
  rows = with(exact_rows(), [](Row& row) { row.omega[0] += 1e-12 * row.t * std::sin(row.t); });
  const Judgement wrong = judged(rows, Parts::rates, tumbling_problem());
  EXPECT_FALSE(wrong.within_digits);
  EXPECT_LT(wrong.digits.rate, 1e-14);
}

// Rounding of the first row is not an error of the program that wrote it. Near the separatrix, the
// last digit decides when the body flips.
TEST(Judge, KnowsHowFarADigitGrows) {
  const Vector3d start(1.2345678e-6, 1, 1.7654321e-6);
  const motion::ExactMotion exact({moments.asDiagonal(), start});
  const std::vector<Row> rows = rows_of([&](double t) { return exact.at(t); }, 1001, 0.2);
  const Judgement judgement = judged(rows, Parts::rates, {.inertia = moments.asDiagonal()}, 9);
  EXPECT_TRUE(judgement.within_digits);
  EXPECT_GT(judgement.rates->max, 1e-4);
  EXPECT_GT(judgement.growth.rates, 1e4);
}

TEST(Judge, OneRowTellsSomethingOnlyOfAStateThatIsGiven) {
  EXPECT_THROW(judged(exact_rows(1), Parts::both, tumbling_problem()), CheckError);
  Problem problem = tumbling_problem();
  problem.omega = omega;
  EXPECT_THROW(judged(exact_rows(1), Parts::both, problem), CheckError);
  const std::vector<Row> rows = exact_rows(11);
  const Judgement judgement = judged({rows.back()}, Parts::rates, problem);
  EXPECT_EQ(judgement.rows, 1U);
  EXPECT_LT(judgement.rates->max, 1e-14);
  EXPECT_TRUE(judgement.within_digits);
}

TEST(Judge, ASphereABodyAtRestAndASteadyOneHaveNoPhase) {
  const Vector3d axis(0, 0.7, 0);
  for (const auto& [I, w] : {std::pair(Vector3d(2, 2, 2), omega),
                             {moments, Vector3d(0, 0, 0)},
                             {moments, axis},
                             {Vector3d(2, 2, 3), Vector3d(0, 0, 1)}}) {
    const motion::FreeBody body(I.asDiagonal(), w);
    const motion::ExactMotion exact(body);
    const auto rows = rows_of([&](double t) { return exact.at(t); }, 101, 0.1);
    const Judgement judgement = judged(rows, Parts::both, {.inertia = I.asDiagonal()});
    EXPECT_TRUE(judgement.within_digits) << I.transpose() << ", " << w.transpose();
    EXPECT_FALSE(judgement.parts);
    EXPECT_TRUE(judgement.flips.empty());
    EXPECT_TRUE(std::isfinite(judgement.energy_drift));
  }
}

/// Rows of a motion near the separatrix, which amplifies the noise of the first row until the phase
/// is lost. The rates of a body with damping decay.
Judgement judged_with_noise(double damping) {
  const motion::ExactMotion exact({inertia, Vector3d(0.02, 1, 0.03)});
  std::vector<Row> rows = rows_of([&](double t) { return exact.at(t); }, 600, 0.2);
  SceneDice dice(1, 2);
  for (Row& row : rows) {
    row.omega *= std::exp(-damping * row.t);
    row.omega += 2e-3 * dice.vector(-1, 1);
  }
  return judged(rows, Parts::rates, tumbling_problem());
}

TEST(Judge, FindsTheMotionInNoiseThatGrows) {
  const Judgement judgement = judged_with_noise(0);
  EXPECT_GT(judgement.rates->max, 0.3);  // a third of the rates
  EXPECT_TRUE(judgement.within_noise);
  EXPECT_FALSE(judged_with_noise(1e-3).within_noise);
}

/// Rows of a body that turns over eight times, with noise in both quantities.
std::vector<Row> rows_with_noise(double of_rates, double of_attitudes, std::uint32_t seed) {
  const motion::ExactMotion exact({inertia, Vector3d(0.02, 1, 0.03)});
  std::vector<Row> rows = rows_of([&](double t) { return exact.at(t); }, 600, 0.2);
  SceneDice dice(seed, 3);
  for (Row& row : rows) {
    row.omega += of_rates * dice.vector(-1, 1);
    row.X *= so3::exp(of_attitudes * dice.vector(-1, 1));
  }
  return rows;
}

// Rates of a gyroscope beside attitudes of a camera, and the reverse: the one must not spoil what
// the other determines, and the motion grows from the noise of the first row.
TEST(Judge, FindsTheMotionInNoiseOfAnyKind) {
  for (const double of_rates : {0.0, 1e-3, 0.08}) {
    for (const double of_attitudes : {0.0, 1e-4, 0.05}) {
      if (of_rates == 0 && of_attitudes == 0) continue;
      for (const Parts parts : {Parts::both, Parts::attitude}) {
        if (parts == Parts::attitude && (of_rates > 0 || of_attitudes == 0)) continue;
        for (const std::uint32_t seed : {0U, 1U}) {
          const Judgement judgement =
              judged(rows_with_noise(of_rates, of_attitudes, seed), parts, tumbling_problem());
          EXPECT_TRUE(judgement.within_noise)
              << of_rates << " " << of_attitudes << " " << seed << " " << judgement.noise.rate
              << " " << judgement.noise.attitude;
        }
      }
    }
  }
}

TEST(Judge, KnowsTheNoiseOfFewRows) {
  for (const std::size_t count : {20U, 40U, 80U}) {
    for (const Parts parts : {Parts::both, Parts::attitude, Parts::rates}) {
      for (std::uint32_t seed = 0; seed < 4; ++seed) {
        std::vector<Row> rows = rows_with_noise(0.02, 0.005, seed);
        rows.resize(count);
        EXPECT_TRUE(judged(rows, parts, tumbling_problem()).within_noise) << count << " " << seed;
      }
    }
  }
}

// Even strong noise does not hide a law that is wrong by a few percent.
TEST(Judge, FindsNoOtherMotionInNoise) {
  Problem other = tumbling_problem();
  other.inertia(1, 1) *= 1.05;
  for (const double of_rates : {0.0, 0.05}) {
    const std::vector<Row> rows = rows_with_noise(of_rates, 1e-3, 1);
    EXPECT_FALSE(judged(rows, Parts::both, other).within_noise) << of_rates;
  }
}

/// A steady rotation as Rodrigues parameters, a thousand of them at half a turn. The axis of one
/// row is tilted by 1e-14.
Judgement judged_rodrigues(int tilted_row) {
  const ScratchFolder folder;
  std::string text = "t,gibbsx,gibbsy,gibbsz,wx,wy,wz\n";
  for (int i = 0; i < 40; ++i) {
    const double t = 0.1 * i, g = std::tan((t + 2e-3 + std::numbers::pi - 2) / 2);
    text += fmt::format("{:.17g},{:.17g},0,{:.17g},0,0,1\n", t, i == tilted_row ? 1e-14 * g : 0, g);
  }
  system::write_file_atomically(folder / "rows.csv", text);
  recording::Convention convention;
  for (const char* name : {"t", "gibbsx", "gibbsy", "gibbsz", "wx", "wy", "wz"})
    convention.columns[name] = name;
  return judge(recording::Recording(folder / "rows.csv"), convention, tumbling_problem());
}

// Near half a turn, programs lose digits of Rodrigues parameters.
TEST(Judge, KnowsHowManyDigitsOfRodriguesParametersAreLost) {
  constexpr int at_half_a_turn = 20, far_from_it = 10;
  EXPECT_TRUE(judged_rodrigues(at_half_a_turn).within_digits);
  EXPECT_FALSE(judged_rodrigues(far_from_it).within_digits);
}

TEST(Judge, KeepsNoMoreThanSomeSpansOfAnyNumberOfRows) {
  std::vector<Row> rows = exact_rows(20'000, 0.01);
  rows[12'345].omega[1] += 1e-3;
  const Judgement judgement = judged(rows, Parts::rates, tumbling_problem());
  EXPECT_EQ(judgement.rows, 20'000U);
  EXPECT_LE(judgement.course.size(), ErrorHistory::most);
  EXPECT_EQ(judgement.course.back().last.t, rows.back().t);
  double most = 0;
  for (const Span& span : judgement.course) most = std::max(most, span.rate_error);
  EXPECT_NEAR(most, 1e-3, 1e-9);
}

}  // namespace
}  // namespace twrench::check
