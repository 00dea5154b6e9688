#include <gtest/gtest.h>
#include <twrench/motion/diagnostics.h>
#include <twrench/motion/error.h>
#include <twrench/motion/propagator.h>
#include <twrench/motion/trajectory.h>

#include <cmath>
#include <memory>
#include <vector>

#include "motion/every_method.h"
#include "motion/reference.h"
#include "motion/scheme.h"

namespace twrench::motion {
namespace {

using Eigen::Matrix3d;

class EveryPropagator : public testing::TestWithParam<Method> {
 protected:
  const FreeBody body_ = reference_case("wrench-a").body;
  const StepControl control_{.step = 0.1};
};

TEST_P(EveryPropagator, SamplesAreThoseOfTheTrajectoryInEitherDirection) {
  for (const Direction direction : {Direction::forward, Direction::backward}) {
    const double sign = direction == Direction::forward ? 1 : -1;
    const auto propagator = make_propagator(body_, GetParam(), control_, direction);
    std::vector<double> times;
    for (int i = 1; i < 20; ++i) times.push_back(sign * 0.37 * i);
    const Trajectory all = integrate(body_, GetParam(), control_, times);
    for (std::size_t i = 0; i < times.size(); ++i) {
      const Sample sample = propagator->sample_at(times[i]);
      EXPECT_EQ(sample.X, all.samples[i].X) << times[i];
      EXPECT_EQ(sample.omega, all.samples[i].omega) << times[i];
    }
    EXPECT_EQ(propagator->steps(), all.steps);
  }
}

TEST_P(EveryPropagator, StartsAtWhatWasGiven) {
  // A velocity that I^-1 (I omega) does not reproduce exactly.
  const FreeBody body(body_.inertia(), {1.0, 0.05, 1e-3});
  const double energy_at_start = energy(body.inertia(), body.omega());
  const std::vector<double> times{-0.3, 0.0, 0.3, 0.0};
  std::vector<Sample> samples = integrate(body, GetParam(), control_, times).samples;
  samples.push_back(make_propagator(body, GetParam(), control_)->sample_at(0));
  for (const std::size_t i : {1U, 3U, 4U}) {
    EXPECT_EQ(samples[i].X, Matrix3d::Identity());
    EXPECT_EQ(samples[i].omega, body.omega());
    const Diagnostics d = diagnose(body, energy_at_start, samples[i]);
    EXPECT_EQ(d.energy_drift, 0);
    EXPECT_EQ(d.orthogonality_error, 0);
    EXPECT_EQ(d.momentum_error, 0);
  }
  EXPECT_NE(samples[0].X, Matrix3d::Identity());
}

TEST_P(EveryPropagator, ItsStepsFollowOneAnother) {
  for (const Direction direction : {Direction::forward, Direction::backward}) {
    const auto propagator = make_propagator(body_, GetParam(), control_, direction);
    EXPECT_EQ(propagator->t(), 0);
    Matrix3d X = Matrix3d::Identity();
    for (int i = 0; i < 20; ++i) {
      const double t = propagator->t();
      const AcceptedStep step = propagator->next_step();
      EXPECT_EQ(step.t, t);
      EXPECT_EQ(step.before, X);
      EXPECT_EQ(step.length > 0, direction == Direction::forward);
      EXPECT_NEAR(propagator->t(), t + step.length, 1e-15 * std::abs(t));
      X = step.after;
    }
  }
}

TEST_P(EveryPropagator, RefusesATimeThatCannotBe) {
  const auto propagator = make_propagator(body_, GetParam(), control_);
  for (const double t : {double{NAN}, double{INFINITY}, -double{INFINITY}}) {
    try {
      propagator->sample_at(t);
      FAIL() << t;
    } catch (const OutOfRange& error) {
      EXPECT_EQ(error.quantity(), "t");
    }
    const std::vector<double> times{0, t};
    EXPECT_THROW(integrate(body_, GetParam(), control_, times), OutOfRange);
    const auto fail = [](const AcceptedStep&) { FAIL() << "a step was taken"; };
    EXPECT_THROW(visit_steps(body_, GetParam(), control_, t, fail), OutOfRange);
  }
  EXPECT_NO_THROW(propagator->sample_at(1)) << "nothing has changed";
}

TEST_P(EveryPropagator, RefusesToGoBack) {
  if (GetParam().exact()) GTEST_SKIP() << "it goes to each time at once";
  const auto propagator = make_propagator(body_, GetParam(), control_);
  propagator->sample_at(50);
  EXPECT_THROW(propagator->sample_at(0.05), InvalidArgument);
  EXPECT_THROW(propagator->sample_at(-50), InvalidArgument);
  EXPECT_NO_THROW(propagator->sample_at(50));
}

TEST_P(EveryPropagator, RefusesAStepThatCannotBe) {
  for (const double step : {0.0, -0.1, double{NAN}, double{INFINITY}}) {
    try {
      make_propagator(body_, GetParam(), {.step = step});
      FAIL() << step;
    } catch (const OutOfRange& error) {
      EXPECT_EQ(error.quantity(), "step");
      EXPECT_EQ(error.least(), 0);
    }
  }
  EXPECT_THROW(make_propagator(body_, GetParam(), {.max_steps = 0}), OutOfRange);
}

TEST_P(EveryPropagator, TakesNoMoreStepsThanItMay) {
  if (GetParam().exact()) GTEST_SKIP() << "it takes none";
  const auto propagator = make_propagator(body_, GetParam(), {.step = 0.1, .max_steps = 3});
  EXPECT_THROW(propagator->sample_at(1e3), MotionError);
}

INSTANTIATE_TEST_SUITE_P(Methods, EveryPropagator, every_method(), method_test_name);

TEST(Propagator, RefusesAToleranceThatCannotBe) {
  const FreeBody body = reference_case("wrench-a").body;
  for (const char* name : {"rkf45", "rkmk45", "taylor"}) {
    for (const double tolerance : {0.0, -1.0, 0.9e-15, double{NAN}, double{INFINITY}}) {
      try {
        make_propagator(body, find_method(name), {.tolerance = tolerance});
        FAIL() << name << ' ' << tolerance;
      } catch (const OutOfRange& error) {
        EXPECT_EQ(error.quantity(), "tolerance");
      }
    }
  }
}

TEST(Propagator, OutlivesWhatItWasMadeFrom) {
  auto body = std::make_unique<FreeBody>(reference_case("wrench-a").body);
  auto method = std::make_unique<Method>(find_method("rkmk4"));
  const std::vector<double> times{3};
  const Matrix3d X = integrate(*body, *method, {}, times).samples[0].X;
  const auto propagator = make_propagator(*body, *method, {});
  body.reset();
  method.reset();
  EXPECT_EQ(propagator->sample_at(3).X, X);
}

TEST(Propagator, OfATaylorSeriesOfAnOrderThatCannotBeIsRefused) {
  const FreeBody body = reference_case("wrench-a").body;
  Method method = find_method("taylor");
  for (const int order : {-2, 0, 1, 7, 31, 32}) {
    try {
      const Scheme scheme{Taylor{order}};
      method.scheme = &scheme;
      make_propagator(body, method, {});
      FAIL() << order;
    } catch (const OutOfRange& error) {
      EXPECT_EQ(error.quantity(), "order");
      EXPECT_EQ(error.value(), order);
      EXPECT_EQ(error.greatest(), 30);
    }
  }
}

}  // namespace
}  // namespace twrench::motion
