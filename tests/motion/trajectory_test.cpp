#include <gtest/gtest.h>
#include <twrench/math/so3.h>
#include <twrench/motion/diagnostics.h>
#include <twrench/motion/error.h>
#include <twrench/motion/exact.h>
#include <twrench/motion/stepper.h>
#include <twrench/motion/trajectory.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "motion/every_method.h"
#include "motion/reference.h"
#include "motion/scheme.h"
#include "sanitizers.h"

namespace twrench::motion {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

std::vector<double> times_of(const ReferenceCase& c) {
  std::vector<double> times;
  for (const Sample& s : c.samples) times.push_back(s.t);
  return times;
}

double worst_error(const ReferenceCase& c, const std::vector<Sample>& samples) {
  double worst = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    worst = std::max(worst, (samples[i].X - c.samples[i].X).norm());
    worst = std::max(worst, (samples[i].omega - c.samples[i].omega).norm());
  }
  return worst;
}

/// Returns the reason why the motion could not be computed; nothing if it could.
template <typename Action>
std::optional<MotionError::Reason> reason(const Action& action) {
  try {
    action();
  } catch (const MotionError& error) {
    return error.reason();
  }
  return std::nullopt;
}

class Task5 : public testing::TestWithParam<const char*> {};

// Task 5: with a small enough step, the error stays below 1e-6 at every reference time up to 100 s.
TEST_P(Task5, ReachesTheReference) {
  if (has_sanitizers) GTEST_SKIP() << "repeats the computation with other numbers";
  const ReferenceCase c = reference_case(GetParam());
  for (const char* name : {"midpoint", "trapezoid", "rk4", "rkf45"}) {
    Method method = find_method(name);
    Scheme scheme = *method.scheme;
    std::get<RungeKutta>(scheme.kind).tableau.embedded_pair = false;  // the test chooses the step
    method.scheme = &scheme;
    const StepControl control{.step = 2e-4};
    EXPECT_LE(worst_error(c, integrate(c.body, method, control, times_of(c)).samples), 1e-6)
        << name;
  }
}

// With its own steps, the printed RKF45 does not reach 1e-6 at any tolerance that doubles can
// represent. Both rows omit the same commutator, (h^3/12) omega x omega', so E does not include it
// and the steps become too long.
TEST_P(Task5, ThePrintedPairCannotBeTrustedWithItsOwnStep) {
  if (has_sanitizers) GTEST_SKIP() << "repeats the computation with other numbers";
  const ReferenceCase c = reference_case(GetParam());
  const StepControl control{.tolerance = 1e-15};
  const double error =
      worst_error(c, integrate(c.body, find_method("rkf45"), control, times_of(c)).samples);
  EXPECT_GT(error, 1e-6);
  EXPECT_LT(error, 1e-4);
}

// "A step length so small that the energy does not change noticeably."
TEST_P(Task5, KeepsTheEnergy) {
  if (has_sanitizers) GTEST_SKIP() << "repeats the computation with other numbers";
  const ReferenceCase c = reference_case(GetParam());
  std::vector<double> times;
  for (int i = 0; i <= 1000; ++i) times.push_back(0.1 * i);
  const double start = energy(c.body.inertia(), c.omega0);
  for (const auto& [name, bound] : {std::pair{"rk4", 2e-6}, std::pair{"rkf45", 3e-5}}) {
    const StepControl control{.step = 0.01, .tolerance = 1e-10};
    double drift = 0;
    for (const Sample& s : integrate(c.body, find_method(name), control, times).samples) {
      const Diagnostics d = diagnose(c.body, start, s);
      drift = std::max(drift, std::abs(d.energy_drift));
      EXPECT_LE(d.orthogonality_error, 1e-12);
      EXPECT_LE(d.momentum_error, 1e-12);
    }
    std::printf("%s %s: largest energy drift over 100 s %.2e\n", GetParam(), name, drift);
    EXPECT_LE(drift, bound) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Task5, testing::Values("wrench-a", "wrench-b", "wrench-c"));

class EveryMethod : public testing::TestWithParam<Method> {
 protected:
  const ReferenceCase wrench_ = reference_case("wrench-a");
  StepControl control_{.step = 0.07, .tolerance = 1e-6};
};

INSTANTIATE_TEST_SUITE_P(All, EveryMethod, every_method(), method_test_name);

// A frame must not depend on which other frames are drawn.
TEST_P(EveryMethod, SampleDoesNotDependOnTheOthers) {
  const std::vector<double> many{0, 3.1, 0.5, 0.7, 0.7, 0.14, 2.999, 3.0};
  const auto together = integrate(wrench_.body, GetParam(), control_, many).samples;
  for (std::size_t i = 0; i < many.size(); ++i) {
    const std::vector<double> one{many[i]};
    const Sample alone = integrate(wrench_.body, GetParam(), control_, one).samples[0];
    EXPECT_EQ(together[i].t, many[i]);
    EXPECT_EQ(together[i].X, alone.X);
    EXPECT_EQ(together[i].omega, alone.omega);
  }
}

TEST_P(EveryMethod, StartsAtTheIdentity) {
  const std::vector<double> start{0};
  const Sample s = integrate(wrench_.body, GetParam(), control_, start).samples[0];
  EXPECT_LE((s.X - Matrix3d::Identity()).norm(), 1e-15);
  EXPECT_LE((s.omega - wrench_.omega0).norm(), 1e-15);
}

TEST_P(EveryMethod, TakesItsOwnStepsAndASmallerLastOne) {
  if (GetParam().adaptive() || GetParam().exact()) GTEST_SKIP() << "no step of its own";
  const std::vector<double> times{0.2};  // 0.07, 0.07, 0.06
  Matrix3d X = Matrix3d::Identity();
  X = take_step(wrench_.body, GetParam(), X, 0.07).X;
  X = take_step(wrench_.body, GetParam(), X, 0.07).X;
  X = take_step(wrench_.body, GetParam(), X, 0.2 - 2 * 0.07).X;
  EXPECT_EQ(integrate(wrench_.body, GetParam(), control_, times).samples[0].X, X);
}

TEST_P(EveryMethod, GoesBackInTime) {
  // Reversing time and the spin is a symmetry: X(-t; omega) = X(t; -omega).
  const FreeBody reversed(wrench_.body.inertia(), -wrench_.omega0);
  const std::vector<double> forth{2.5}, back{-2.5};
  const Sample a = integrate(wrench_.body, GetParam(), control_, back).samples[0];
  const Sample b = integrate(reversed, GetParam(), control_, forth).samples[0];
  EXPECT_LE((a.X - b.X).norm(), 1e-14);
}

TEST_P(EveryMethod, ABodyAtRestStaysAtRest) {
  const FreeBody still(wrench_.body.inertia(), Vector3d::Zero());
  const std::vector<double> times{100};
  EXPECT_EQ(integrate(still, GetParam(), control_, times).samples[0].X, Matrix3d::Identity());
}

TEST(Adaptive, StepsFollowSauersControl) {
  // The bound on E applies to each step: two runs whose tolerances differ by 32 = 2^5 differ in
  // their number of steps by about 32^(1/5) = 2, because E scales as h^5.
  const ReferenceCase c = reference_case("wrench-a");
  const auto steps_with = [&](double tolerance) {
    const std::vector<double> times{100};
    for (std::int64_t n = 1;; n += 1 + n / 50) {
      const StepControl control{.step = 0.01, .tolerance = tolerance, .max_steps = n};
      try {
        integrate(c.body, find_method("rkf45"), control, times);
        return static_cast<double>(n);
      } catch (const MotionError&) {
      }
    }
  };
  EXPECT_NEAR(steps_with(1e-9 / 32) / steps_with(1e-9), 2.0, 0.25);
}

// For constant omega the estimate vanishes, and the step-size control would grow steps without
// limit.
TEST(Adaptive, NoStepOfItsOwnIsLongerThanATurn) {
  const FreeBody at_rest(Vector3d(1, 2, 3).asDiagonal(), Vector3d::Zero());
  for (const char* name : {"rkf45", "rkmk45"}) {
    for (const Vector3d& moments : {Vector3d(1, 1, 1), Vector3d(1, 2, 3)}) {
      for (const double omega : {1e-300, 1e-9, 1.0, 1e10}) {
        SCOPED_TRACE(testing::Message() << name << ' ' << moments.transpose() << ' ' << omega);
        for (int axis = 0; axis < 3; ++axis) {
          const Vector3d velocity = omega * Vector3d::Unit(axis);
          const FreeBody body(moments.asDiagonal(), velocity);
          const std::vector<double> times{std::min(1e9, 1000 / omega), -std::min(1e9, 10 / omega)};
          for (const double first : {1e-12, 0.01, 1e6}) {
            const auto run = integrate(body, find_method(name), {.step = first}, times);
            for (const Sample& s : run.samples) {
              EXPECT_LE((s.X - so3::exp(s.t * velocity)).norm(), 1e-11);
            }
            EXPECT_LT(run.steps, 300);
          }
        }
      }
    }
    const std::vector<double> late{1e9};
    EXPECT_EQ(integrate(at_rest, find_method(name), {}, late).samples[0].X, Matrix3d::Identity());
  }
}

TEST(Adaptive, RefusesAToleranceBelowRoundOff) {
  const ReferenceCase c = reference_case("wrench-a");
  const std::vector<double> times{10};
  const StepControl control{.tolerance = 0.9e-15};
  try {
    integrate(c.body, find_method("rkf45"), control, times);
    FAIL();
  } catch (const OutOfRange& error) {
    EXPECT_EQ(error.quantity(), "tolerance");
    EXPECT_EQ(error.value(), 0.9e-15);
    EXPECT_EQ(error.least(), min_tolerance);
  }
}

TEST(Adaptive, EndsWhenTheStepUnderflows) {
  // So fast that the square of the rate overflows, but not the energy. No step, however short, has
  // a finite estimate.
  const FreeBody fast(1e-200 * Vector3d(1, 2, 3).asDiagonal(), {1e200, 1e200, 1e200});
  const std::vector<double> times{1};
  EXPECT_EQ(reason([&] { integrate(fast, find_method("rkf45"), {}, times); }),
            MotionError::Reason::step_underflow);
}

TEST(Trajectory, EndsWhenTheStepsRunOut) {
  const ReferenceCase c = reference_case("wrench-a");
  const std::vector<double> times{10};
  const StepControl control{.step = 0.01, .max_steps = 999};
  EXPECT_EQ(reason([&] { integrate(c.body, find_method("rk4"), control, times); }),
            MotionError::Reason::too_many_steps);
  for (const char* name : {"rkmk45", "taylor"}) {
    const StepControl few{.max_steps = 1};
    EXPECT_EQ(reason([&] { integrate(c.body, find_method(name), few, times); }),
              MotionError::Reason::out_of_steps)
        << name;
  }
  const StepControl enough{.step = 0.01, .max_steps = 1001};
  EXPECT_NO_THROW(integrate(c.body, find_method("rk4"), enough, times));
}

// A needle turns slowly, but its nutation takes 1e-12 s.
TEST(Trajectory, EstimatesTheStepsThatAMethodChooses) {
  const FreeBody needle(Eigen::Vector3d(1e-12, 1, 1).asDiagonal(), Eigen::Vector3d(1, 2, 3));
  const FreeBody body(Eigen::Vector3d(2, 3, 4).asDiagonal(), Eigen::Vector3d(1, 2, 3));
  const std::vector<double> minute{60}, ages{0, -1e15};
  EXPECT_EQ(reason([&] { integrate(needle, find_method("taylor"), {}, minute); }),
            MotionError::Reason::out_of_steps);
  EXPECT_EQ(reason([&] { visit_steps(needle, find_method("taylor"), {}, 60, [](auto&) {}); }),
            MotionError::Reason::out_of_steps);
  for (const char* name : {"taylor", "rkmk45", "rkf45"}) {
    EXPECT_EQ(reason([&] { integrate(body, find_method(name), {}, ages); }),
              MotionError::Reason::out_of_steps)
        << name;
  }
  EXPECT_NO_THROW(integrate(body, find_method("exact"), {}, ages));
  EXPECT_NO_THROW(integrate(body, find_method("taylor"), {.max_steps = 1000}, minute));
}

// The error must come before the first step, because so many steps would take minutes.
TEST(Trajectory, RefusesMoreFixedStepsThanAllowedAtOnce) {
  const ReferenceCase c = reference_case("wrench-a");
  const std::vector<double> times{0, -1e9};
  const StepControl control{.step = 1e-9};
  for (const char* name : {"rk4", "suzuki4", "exact"}) {
    if (!find_method(name).exact()) {
      EXPECT_THROW(integrate(c.body, find_method(name), control, times), MotionError) << name;
    }
    const auto fail = [](const AcceptedStep&) { FAIL() << "a step was taken"; };
    EXPECT_THROW(visit_steps(c.body, find_method(name), control, 1e9, fail), MotionError) << name;
  }
}

TEST(Taylor, ReachesTheReferenceAtEveryTime) {
  for (const ReferenceCase& c : reference_cases()) {
    const StepControl control{.tolerance = 1e-14};
    const auto samples = integrate(c.body, find_method("taylor"), control, times_of(c)).samples;
    EXPECT_LE(worst_error(c, samples), 2e-11) << c.name;
  }
}

// Samples within a step evaluate the series, so they are as accurate as its end.
TEST(Taylor, SamplesBetweenStepsAreOfTheSameAccuracy) {
  const ReferenceCase c = reference_case("wrench-a");
  const ExactMotion exact(c.body);
  std::vector<double> times;
  for (int i = -1000; i <= 1000; ++i) times.push_back(0.02 * i);
  const Trajectory motion = integrate(c.body, find_method("taylor"), {.tolerance = 1e-12}, times);
  EXPECT_LE(motion.steps, 50);  // most samples lie between
  for (const Sample& s : motion.samples) {
    EXPECT_LE((s.X - exact.at(s.t).X).norm(), 1e-11) << s.t;
    EXPECT_LE((s.omega - exact.at(s.t).omega).norm(), 1e-11) << s.t;
    EXPECT_LE((s.X.transpose() * s.X - Matrix3d::Identity()).norm(), 1e-14) << s.t;
  }
}

TEST(Taylor, KeepsTheEnergyWhateverTheTolerance) {
  const ReferenceCase c = reference_case("wrench-a");
  const double start = energy(c.body.inertia(), c.omega0);
  const std::vector<double> times{1, 10, 100, 1000, 10'000};
  for (const double tolerance : {1e-6, 1e-10, 1e-15}) {
    for (const Sample& s :
         integrate(c.body, find_method("taylor"), {.tolerance = tolerance}, times).samples) {
      EXPECT_LE(std::abs(energy(c.body.inertia(), s.omega) / start - 1), 1e-14) << tolerance;
      EXPECT_LE((s.X * (c.body.inertia() * s.omega) - c.body.momentum()).norm(),
                1e-12 * c.body.momentum().norm());
    }
  }
}

TEST(Trajectory, SaysWhenAMethodHasDiverged) {
  const FreeBody fast(Vector3d(1, 2, 3).asDiagonal(), {0.1, 100, 0.1});
  const std::vector<double> times{1e3};
  const StepControl control{.step = 0.06};
  EXPECT_EQ(reason([&] { integrate(fast, find_method("euler"), control, times); }),
            MotionError::Reason::diverged);
}

TEST(Trajectory, RefusesAStepLongerThanATurn) {
  const ReferenceCase c = reference_case("wrench-a");  // a revolution takes 2 pi s
  const std::vector<double> times{10};
  for (const char* name : {"euler", "rk4", "rkf45", "strang", "cf4", "exact"}) {
    const Method& method = find_method(name);
    const bool chooses = method.adaptive() || method.exact();
    EXPECT_NO_THROW(integrate(c.body, method, {.step = 6.2}, times)) << name;
    if (chooses) {
      EXPECT_NO_THROW(integrate(c.body, method, {.step = 7}, times)) << name;
    } else {
      EXPECT_EQ(reason([&] { integrate(c.body, method, {.step = 7}, times); }),
                MotionError::Reason::step_too_long)
          << name;
    }
  }
}

TEST_P(EveryMethod, VisitedSamplesAreThoseOfTheTrajectory) {
  const auto time = [](std::size_t i) { return 0.13 * static_cast<double>(i); };
  std::vector<double> times;
  for (std::size_t i = 0; i < 50; ++i) times.push_back(time(i));
  const auto samples = integrate(wrench_.body, GetParam(), control_, times).samples;
  std::size_t next = 0;
  visit_samples(wrench_.body, GetParam(), control_, times.size(), time, [&](const Sample& s) {
    EXPECT_EQ(s.t, samples[next].t);
    EXPECT_EQ(s.X, samples[next].X);
    EXPECT_EQ(s.omega, samples[next++].omega);
  });
  EXPECT_EQ(next, times.size());
}

// Divergence must be reported well below infinity, because squares of the results would overflow.
TEST(Trajectory, NothingThatIsToldOverflows) {
  const FreeBody fast(Vector3d(1, 2, 3).asDiagonal(), {0.1, 100, 0.1});
  std::vector<double> times;
  for (int i = 0; i < 2000; ++i) times.push_back(0.06 * i);
  const double start = energy(fast.inertia(), fast.omega());
  const auto look = [&](const Sample& s) {
    const Diagnostics d = diagnose(fast, start, s);
    EXPECT_TRUE(
        std::isfinite(d.energy + d.energy_drift + d.orthogonality_error + d.momentum_error));
  };
  const auto time = [&](std::size_t i) { return times[i]; };
  EXPECT_EQ(reason([&] {
              visit_samples(fast, find_method("euler"), {.step = 0.06}, times.size(), time, look);
            }),
            MotionError::Reason::diverged);
}

class VisitSteps : public testing::TestWithParam<Method> {};

TEST_P(VisitSteps, AreThoseOfTheTrajectory) {
  const ReferenceCase c = reference_case("wrench-a");
  const StepControl control{.step = 0.1, .tolerance = 1e-9};
  std::vector<AcceptedStep> steps;
  visit_steps(c.body, GetParam(), control, 5.05,
              [&](const AcceptedStep& s) { steps.push_back(s); });
  ASSERT_FALSE(steps.empty());
  EXPECT_EQ(steps.front().t, 0);
  EXPECT_EQ(steps.front().before, Matrix3d::Identity());
  EXPECT_LT(steps.back().t, 5.05);
  EXPECT_GE(steps.back().t + steps.back().length, 5.05);
  std::vector<double> ends;
  for (const AcceptedStep& s : steps) ends.push_back(s.t + s.length);
  const auto samples = integrate(c.body, GetParam(), control, ends).samples;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    EXPECT_LE((steps[i].after - samples[i].X).norm(), 1e-14) << i;
    EXPECT_LE(steps[i].error, GetParam().adaptive() ? control.tolerance * (1 + 1e-12) : 0);
    if (i > 0) {
      EXPECT_EQ(steps[i].before, steps[i - 1].after);
      EXPECT_NEAR(steps[i].t, ends[i - 1], 1e-14);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, VisitSteps, every_method(), method_test_name);

}  // namespace
}  // namespace twrench::motion
