// The motion through the rows of a recording, against the exact motion.
#include "recording/motion_of_rows.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <twrench/base/error.h>
#include <twrench/math/so3.h>
#include <twrench/motion/exact.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>

#include "recording/columns/open_conventions.h"

namespace twrench::recording {
namespace {

using Eigen::Vector3d;

/// The quantities of a recording.
enum class Contents { rates, attitudes, both };

const motion::ExactMotion& tumbling() {
  static const motion::ExactMotion motion(
      motion::FreeBody(Vector3d(2, 3, 4.5).asDiagonal(), Vector3d(0.3, 2, 0.4)));
  return motion;
}

/// A row with that many digits; `t` is that of the file's clock.
std::string row_with(Contents columns, const motion::Sample& sample, double t, int digits = 17) {
  std::string text = fmt::format("{:.17g}", t);
  const auto add = [&](double value) { text += fmt::format(",{:.{}g}", value, digits); };
  if (columns != Contents::attitudes) std::ranges::for_each(sample.omega, add);
  if (columns != Contents::rates) {
    const auto q = sample.quaternion();
    for (const double value : {q.w(), q.x(), q.y(), q.z()}) add(value);
  }
  return text + "\n";
}

std::string line_of_names(Contents columns) {
  switch (columns) {
    case Contents::rates:
      return "t,wx,wy,wz\n";
    case Contents::attitudes:
      return "t,qw,qx,qy,qz\n";
    case Contents::both:
      return "t,wx,wy,wz,qw,qx,qy,qz\n";
  }
  return {};
}

std::string table_of(Contents columns, const std::function<double(int)>& time, int count,
                     int digits = 17) {
  std::string text = line_of_names(columns);
  for (int i = 0; i < count; ++i)
    text += row_with(columns, tumbling().at(time(i)), time(i) + 100, digits);
  return text;
}

MotionOfRows motion_of(const std::string& text, const Extract& extract = {},
                       const Eigen::Quaterniond& start = Eigen::Quaterniond::Identity()) {
  const Recording recording = Recording(table::open_table("run.csv", text)).between(extract);
  return motion_of_rows(recording, conventions(recording.header(), {}).at(0), start);
}

/// The largest angle to the exact motion, in rad, over the whole recording.
double error_of(const MotionOfRows& shown, double start = 0) {
  constexpr int times = 3571;
  double error = 0;
  for (int i = 0; i <= times; ++i) {
    const double t = shown.motion.duration() * i / times;
    const Eigen::Matrix3d ought = tumbling().at(start + t).X;
    error = std::max(error, so3::log(ought.transpose() * shown.motion.at(t).X).norm());
  }
  return error;
}

double error_at_step(Contents columns, double step) {
  const int count = static_cast<int>(std::lround(20 / step)) + 1;
  return error_of(motion_of(table_of(
      columns, [=](int i) { return i * step; }, count)));
}

TEST(MotionOfRows, HasOrderFour) {
  for (const Contents columns : {Contents::both, Contents::attitudes, Contents::rates}) {
    const double coarse = error_at_step(columns, 0.1), fine = error_at_step(columns, 0.05);
    EXPECT_NEAR(std::log2(coarse / fine), 4, 0.25)
        << line_of_names(columns) << coarse << " " << fine;
  }
}

TEST(MotionOfRows, AgreesWithTheExactMotionWithinTheDigits) {
  const auto every_20_ms = [](int i) { return 0.02 * i; };
  EXPECT_LT(error_of(motion_of(table_of(Contents::both, every_20_ms, 1001, 9))), 3e-8);
  EXPECT_LT(error_of(motion_of(table_of(Contents::attitudes, every_20_ms, 1001, 9))), 3e-8);
  EXPECT_LT(error_of(motion_of(table_of(Contents::rates, every_20_ms, 1001, 9))), 1e-6);
}

TEST(MotionOfRows, TakesTimesThatAreNotEvenlySpaced) {
  const auto uneven = [](int i) { return 0.02 * i + 0.008 * std::sin(double(i)); };
  for (const Contents columns : {Contents::both, Contents::attitudes, Contents::rates}) {
    EXPECT_LT(error_of(motion_of(table_of(columns, uneven, 1001))), 1e-6) << line_of_names(columns);
  }
}

TEST(MotionOfRows, EstimatesTheDriftOfIntegratedRates) {
  for (const double step : {0.02, 0.1, 0.3}) {
    const int count = static_cast<int>(20 / step);
    const MotionOfRows shown = motion_of(table_of(
        Contents::rates, [=](int i) { return i * step; }, count));
    const double t = shown.motion.duration();
    const double error = so3::log(tumbling().at(t).X.transpose() * shown.motion.at(t).X).norm();
    EXPECT_GT(shown.drift, error) << step;
    EXPECT_LT(shown.drift, 40 * error) << step;
  }
  EXPECT_EQ(motion_of(table_of(
                          Contents::both, [](int i) { return 0.1 * i; }, 50))
                .drift,
            0);
}

TEST(MotionOfRows, StartsFromTheGivenAttitude) {
  const Eigen::Quaterniond start(Eigen::AngleAxisd(1, Vector3d(1, 2, 2) / 3));
  const std::string text = table_of(
      Contents::rates, [](int i) { return 0.05 * i; }, 200);
  const MotionOfRows shown = motion_of(text, {}, start);
  EXPECT_LT(so3::log((start * tumbling().at(3).X).transpose() * shown.motion.at(3).X).norm(), 1e-5);
}

TEST(MotionOfRows, CutsAndKeepsTheClock) {
  const std::string text = table_of(
      Contents::both, [](int i) { return 0.05 * i; }, 201);
  const MotionOfRows shown = motion_of(text, {.from = 2, .to = 7});
  EXPECT_DOUBLE_EQ(shown.clock_start, 102);
  EXPECT_DOUBLE_EQ(shown.motion.duration(), 5);
  EXPECT_LT(error_of(shown, 2), 1e-6);
}

TEST(MotionOfRows, HoldsTheBodyInGaps) {
  for (const Contents columns : {Contents::both, Contents::attitudes, Contents::rates}) {
    const auto with_gap = [](int i) { return 0.05 * (i < 100 ? i : i + 10); };
    const MotionOfRows shown = motion_of(table_of(columns, with_gap, 200));
    EXPECT_EQ(shown.gaps, 1U);
    EXPECT_TRUE(shown.motion.is_in_gap(5));
    EXPECT_EQ(shown.motion.at(5).X, shown.motion.at(4.95 + 1e-9).X);
    EXPECT_FALSE(shown.motion.is_in_gap(6));
    // Four intervals are no gap.
    const auto skipping = [](int i) { return 0.05 * (i < 100 ? i : i + 3); };
    EXPECT_EQ(motion_of(table_of(columns, skipping, 200)).gaps, 0U);
  }
}

/// A row whose values have noise of that standard deviation in each component.
class NoisyRows {
 public:
  NoisyRows(double rate_noise, double attitude_noise)
      : rate_noise_(rate_noise), attitude_noise_(attitude_noise) {}

  motion::Sample row(motion::Sample sample) {
    sample.omega += rate_noise_ * vector();
    sample.X = sample.X * so3::exp(attitude_noise_ * vector());
    return sample;
  }

 private:
  /// The sum of twelve numbers between -1/2 and 1/2 has the variance 1. The distributions of the
  /// standard library differ from one to another.
  Vector3d vector() {
    Vector3d sum = Vector3d::Zero();
    for (double& component : sum) {
      for (int i = 0; i < 12; ++i) component += double(engine_()) / double(engine_.max()) - 0.5;
    }
    return sum;
  }

  std::mt19937 engine_{7};
  double rate_noise_, attitude_noise_;
};

constexpr double rate_noise = 0.03, attitude_noise = 0.01;

std::string noisy_table(Contents columns, const std::function<double(int)>& time, int count) {
  NoisyRows noisy(rate_noise, attitude_noise);
  std::string text = line_of_names(columns);
  for (int i = 0; i < count; ++i) {
    text += row_with(columns, noisy.row(tumbling().at(time(i))), time(i));
  }
  return text;
}

MotionOfRows smooth_motion_of(const std::string& text) {
  const Recording recording(table::open_table("run.csv", text));
  return motion_of_rows(recording, conventions(recording.header(), {}).at(0),
                        Eigen::Quaterniond::Identity(), Smoothing::within_noise);
}

/// The root mean squares of the errors of the rows, in each of three components.
struct RowErrors {
  double attitude = 0, rates = 0;
};

RowErrors errors_of_rows(const MotionOfRows& shown) {
  RowErrors squares;
  for (const motion::RecordedMotion::Instant& row : shown.motion.instants()) {
    const motion::Sample ought = tumbling().at(row.t);
    const Eigen::Quaterniond X(row.X);
    squares.attitude += so3::log(ought.X.transpose() * X.toRotationMatrix()).squaredNorm();
    squares.rates += (row.omega - ought.omega).squaredNorm();
  }
  const double values = 3.0 * double(shown.motion.instants().size());
  return {std::sqrt(squares.attitude / values), std::sqrt(squares.rates / values)};
}

TEST(MotionOfRows, MeasuresNoise) {
  const auto even = [](int i) { return 0.02 * i; };
  const auto uneven = [](int i) { return 0.02 * i + 0.008 * std::sin(double(i)); };
  for (const std::function<double(int)>& time : {std::function<double(int)>(even), {uneven}}) {
    const RowNoise noise = motion_of(noisy_table(Contents::both, time, 1001)).noise;
    ASSERT_TRUE(noise.attitude && noise.rates);
    EXPECT_NEAR(*noise.attitude / attitude_noise, 1, 0.1);
    EXPECT_NEAR(*noise.rates / rate_noise, 1, 0.1);
  }
}

TEST(MotionOfRows, TellsNoiseFromOtherErrors) {
  // Errors that depend on their neighbours, of 30 rows a period: the sixth differences are smaller.
  std::string text = "t,wx,wy,wz\n";
  for (int i = 0; i < 500; ++i) {
    motion::Sample sample = tumbling().at(0.02 * i);
    sample.omega.x() += 0.03 * std::sin(0.2 * i);
    text += row_with(Contents::rates, sample, 0.02 * i);
  }
  EXPECT_FALSE(motion_of(text).noise.rates.has_value());
  EXPECT_FALSE(motion_of(text).noise.attitude.has_value());
}

TEST(MotionOfRows, SmoothsWithinTheNoise) {
  const auto even = [](int i) { return 0.02 * i; };
  const auto uneven = [](int i) { return 0.02 * i + 0.008 * std::sin(double(i)); };
  for (const std::function<double(int)>& time : {std::function<double(int)>(even), {uneven}}) {
    const std::string text = noisy_table(Contents::both, time, 1001);
    const RowErrors before = errors_of_rows(motion_of(text));
    const RowErrors after = errors_of_rows(smooth_motion_of(text));
    EXPECT_NEAR(before.attitude / attitude_noise, 1, 0.05);
    EXPECT_LT(after.attitude, 0.35 * before.attitude);
    EXPECT_LT(after.rates, 0.3 * before.rates);
    // Rates that follow from attitudes gain most.
    const std::string attitudes = noisy_table(Contents::attitudes, time, 1001);
    EXPECT_LT(errors_of_rows(smooth_motion_of(attitudes)).rates,
              0.1 * errors_of_rows(motion_of(attitudes)).rates);
    const std::string rates = noisy_table(Contents::rates, time, 1001);
    EXPECT_LT(errors_of_rows(smooth_motion_of(rates)).rates, 0.3 * rate_noise);
  }
}

TEST(MotionOfRows, SmoothingRemovesNoMoreThanTheNoise) {
  const std::string text = noisy_table(
      Contents::both, [](int i) { return 0.02 * i; }, 1001);
  const MotionOfRows rows = motion_of(text), smooth = smooth_motion_of(text);
  double squares = 0;
  for (std::size_t i = 0; i < rows.motion.instants().size(); ++i) {
    squares += (rows.motion.instants()[i].omega - smooth.motion.instants()[i].omega).squaredNorm();
  }
  EXPECT_NEAR(std::sqrt(squares / 3003) / *rows.noise.rates, 1, 0.01);
}

TEST(MotionOfRows, SmoothingHidesNoDrift) {
  const std::string text = noisy_table(
      Contents::rates, [](int i) { return 0.02 * i; }, 1001);
  EXPECT_GT(motion_of(text).drift, 1e-3);
  EXPECT_EQ(smooth_motion_of(text).drift, motion_of(text).drift);
}

TEST(MotionOfRows, SmoothingKeepsDigits) {
  for (const Contents columns : {Contents::both, Contents::attitudes, Contents::rates}) {
    const std::string text = table_of(
        columns, [](int i) { return 0.02 * i; }, 1001, 9);
    EXPECT_LT(error_of(smooth_motion_of(text)), 1e-6) << line_of_names(columns);
  }
}

std::string why_not_shown(const std::string& text, const Extract& extract = {}) {
  try {
    motion_of(text, extract);
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "no error";
}

TEST(MotionOfRows, RefusesWhatIsNoMotion) {
  EXPECT_EQ(why_not_shown("t,wx,wy,wz\n0,1,2,3\n"),
            "run.csv: 1 row to show, but a motion needs two");
  const std::string text = table_of(
      Contents::both, [](int i) { return 0.05 * i; }, 20);
  EXPECT_THROW(motion_of(text, {.from = 5}), table::BadTable);
  EXPECT_THROW(motion_of(text, {.from = 0.41, .to = 0.44}), table::BadTable);
  EXPECT_EQ(why_not_shown("t,wx,wy,wz\n0,1,2,3\n0.3,1,2,3\n0.6,12,0,0\n0.9,1,2,3\n"),
            "run.csv: the body turns by 206 degrees between two rows, 0.3 s after the first row, "
            "so its way is ambiguous");
  EXPECT_EQ(why_not_shown("t,qw,qx,qy,qz\n0,1,0,0,0\n1,0.2,0.98,0,0\n2,1,0,0,0\n"),
            "run.csv: the body turns by 157 degrees between two rows, 0 s after the first row, "
            "so its way is ambiguous");
}

TEST(MotionOfRows, ShowsABodyAtRest) {
  const MotionOfRows shown = motion_of("t,qw,qx,qy,qz\n0,1,0,0,0\n1,1,0,0,0\n2,1,0,0,0\n");
  EXPECT_EQ(shown.motion.at(0.7).X, Eigen::Matrix3d::Identity());
  for (const motion::RecordedMotion::Instant& instant : shown.motion.instants()) {
    EXPECT_EQ(instant.omega.norm(), 0);
  }
}

}  // namespace
}  // namespace twrench::recording
