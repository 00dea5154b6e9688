// Motions of bodies with a wheel or energy loss: L is constant, and the energy decreases or is
// constant.
#include <gtest/gtest.h>
#include <twrench/base/error.h>
#include <twrench/math/so3.h>
#include <twrench/motion/diagnostics.h>
#include <twrench/motion/exact.h>
#include <twrench/motion/rotating_frame.h>
#include <twrench/motion/stepper.h>
#include <twrench/motion/trajectory.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "motion/every_method.h"
#include "motion/interior_series.h"
#include "motion/random_bodies.h"
#include "motion/reference.h"

namespace twrench::motion {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

const Matrix3d identity = Matrix3d::Identity();
constexpr double never = std::numeric_limits<double>::infinity();

std::unique_ptr<Propagator> taylor(const FreeBody& body, Direction direction = Direction::forward) {
  return make_propagator(body, find_method("taylor"), {.tolerance = 1e-15}, direction);
}

TEST(Interior, TaylorAgreesWithTheReference) {
  for (const ReferenceCase& c : constant_momentum_cases()) {
    const auto motion = taylor(c.body);
    for (const Sample& expected : c.samples) {
      const Sample sample = motion->sample_at(expected.t);
      EXPECT_LE((sample.X - expected.X).norm(), 1e-12) << c.name << ", t = " << expected.t;
      EXPECT_LE((sample.omega - expected.omega).norm(), 1e-12) << c.name << ", t = " << expected.t;
    }
  }
}

class InteriorMethod : public testing::TestWithParam<Method> {};

/// Uses a wheel and energy loss together, so that every term of the rate is tested.
TEST_P(InteriorMethod, HasItsOrder) {
  const Method& method = GetParam();
  if (method.exact() || *method.order > 4) GTEST_SKIP() << "no steps whose error has a slope";
  const ReferenceCase both = constant_momentum_cases().back();
  ASSERT_GT(both.body.energy_loss(), 0);
  const auto error_after = [&](int steps) {
    const Sample& end = both.samples[1];
    Matrix3d X = identity;
    for (int i = 0; i < steps; ++i) X = take_step(both.body, method, X, end.t / steps).X;
    return (X - end.X).norm();
  };
  const int steps = method.order == 1 ? 12800 : 400;
  const double slope = std::log2(error_after(steps) / error_after(2 * steps));
  EXPECT_GT(slope, *method.order - 0.1);
  EXPECT_LT(slope, *method.order + 0.3);
}

/// X (I w + h) = L holds for the w of each state, and no step increases the energy.
TEST_P(InteriorMethod, KeepsTheMomentumAndLosesEnergy) {
  const Method& method = GetParam();
  if (method.exact() || method.linear()) GTEST_SKIP() << "no closed form; leaves SO(3)";
  for (const ReferenceCase& c : constant_momentum_cases()) {
    const double initial = energy(c.body.inertia(), c.body.omega());
    double before = initial, least = initial, most = initial;
    visit_steps(c.body, method, {.step = 0.01, .tolerance = 1e-9}, 20,
                [&](const AcceptedStep& step) {
                  const Sample end{step.t + step.length, step.after,
                                   angular_velocity(c.body, method, step.after)};
                  const Diagnostics d = diagnose(c.body, initial, end);
                  EXPECT_LE(d.momentum_error, 1e-13) << c.name;
                  if (c.body.energy_loss() > 0) {
                    EXPECT_LE(d.energy, before * (1 + 1e-15)) << c.name << " " << end.t;
                  }
                  before = d.energy;
                  least = std::min(least, d.energy);
                  most = std::max(most, d.energy);
                });
    // Methods that conserve it to round-off; taylor does so only for rigid bodies.
    if (c.body.energy_loss() == 0 && method.conserves_energy && !method.adaptive()) {
      EXPECT_LE((most - least) / initial, 5e-13) << c.name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, InteriorMethod, every_method(), method_test_name);

/// The closed form of a symmetric body or a sphere with a wheel along its axis.
TEST(Interior, ExactAgreesWithTaylorWhereThereIsAClosedForm) {
  RandomBodies random;
  const Matrix3d attitude = so3::exp({0.3, -1.1, 0.7});
  for (int n = 0; n < 40; ++n) {
    Vector3d moments = random.moments(), wheel = Vector3d::Zero();
    const int axis = n % 2 == 0 ? 0 : 2;
    std::ranges::sort(moments);
    moments[1] = moments[2 - axis];
    if (n % 5 == 4) {
      moments = Vector3d::Constant(moments[1]);
      wheel = random.omega();
    } else {
      wheel[axis] = random.omega()[0] * moments[axis];
    }
    const FreeBody body(moments.asDiagonal(), random.omega(), attitude, {.wheel = wheel});
    const ExactMotion exact(body);
    EXPECT_FALSE(exact.flips());
    for (const double t : {0.7, 3.0, 10.0}) {
      const auto motion = taylor(body);
      const Sample expected = motion->sample_at(t), sample = exact.at(t);
      const double bound = 2e-13 * (1 + body.fastest_rate() * t);
      EXPECT_LE((sample.X - expected.X).norm(), bound) << n;
      EXPECT_LE((sample.omega - expected.omega).norm(), bound * (1 + body.fastest_rate())) << n;
    }
    const double period = exact.nutation_period().value();
    EXPECT_LE((exact.at(period).omega - body.omega()).norm(), 1e-12 * body.omega().norm());
  }
}

TEST(Interior, ExactIsRefusedWhereThereIsNoClosedForm) {
  for (const Interior& interior :
       {Interior{.wheel = {0, 0, 1}}, Interior{.energy_loss_time = 50}}) {
    const FreeBody body(Vector3d(3, 4, 5).asDiagonal(), {1, 0.1, 0.2}, identity, interior);
    try {
      ExactMotion{body};
      FAIL();
    } catch (const InvalidArgument& refused) {
      EXPECT_EQ(refused.quantity(), "method exact");
      EXPECT_EQ(refused.remedy(), "use the method taylor");
    }
  }
  EXPECT_THROW(ExactMotion(FreeBody(Vector3d(3, 3, 5).asDiagonal(), {1, 0.1, 0.2}, identity,
                                    {.wheel = {0, 1e-9, 1}})),
               InvalidArgument);
}

/// In this time the tilt of a small nutation about the axis of greatest moment decreases by a
/// factor e.
TEST(Interior, EnergyLossTimeIsThatOfASmallNutation) {
  for (const double tau : {2.0, 10.0, 200.0}) {
    const FreeBody body(Vector3d(3, 4, 5).asDiagonal(), {1e-5, 2e-5, 1.5}, identity,
                        {.energy_loss_time = tau});
    // The tilt is compared over whole turns of the nutation, whose frequency is the imaginary part
    // of the eigenvalues.
    const double G = body.momentum().norm(), p = 1. / 3 - 1. / 5, q = 1. / 4 - 1. / 5;
    const double in_phase = body.energy_loss() * G * G * (p - q) / 2;
    const double turn = 2 * std::numbers::pi / std::sqrt(G * G * p * q - in_phase * in_phase);
    const auto motion = taylor(body);
    const auto tilt = [&](double t) {
      const Vector3d m = motion->sample_at(t).X.transpose() * body.momentum();
      return std::hypot(m[0], m[1]);
    };
    const double first = tilt(turn), second = tilt(3 * turn);
    EXPECT_NEAR(std::log(first / second) / (2 * turn), 1 / tau, 1e-6 / tau);
  }
}

TEST(Interior, WithoutAnyIsTheMotionOfTheRigidBody) {
  const Matrix3d inertia = Vector3d(1, 2, 3).asDiagonal();
  const FreeBody rigid(inertia, {0.1, 1, 0.2}), other(inertia, {0.1, 1, 0.2}, identity, Interior{});
  EXPECT_TRUE(other.is_rigid());
  EXPECT_EQ(ExactMotion(rigid).at(3).X, ExactMotion(other).at(3).X);
  EXPECT_FALSE(FreeBody(inertia, {0.1, 1, 0.2}, identity, {.wheel = {0, 0, 1}}).is_rigid());
}

TEST(Interior, AWheelAddsToTheMomentum) {
  const Vector3d omega(0.1, 1, 0.2), wheel(0.4, -0.5, 0.6);
  const Matrix3d attitude = so3::exp({0.3, -1.1, 0.7});
  const FreeBody body(Vector3d(1, 2, 3).asDiagonal(), omega, attitude, {.wheel = wheel});
  EXPECT_LE((attitude.transpose() * body.momentum() - Vector3d(0.5, 1.5, 1.2)).norm(), 1e-15);
  EXPECT_LE((body.rigid_velocity(body.body_momentum()) - omega).norm(), 1e-15);
  EXPECT_EQ(body.initial_rate(), omega);
  EXPECT_NEAR(body.energy(body.body_momentum()), energy(body.inertia(), omega), 1e-15);
  EXPECT_EQ(body.with_omega({0, 0, 1}).interior().wheel, wheel);
}

/// L = 0, but the body turns steadily against the momentum of its wheel.
TEST(Interior, TurnsAgainstAWheelWithoutMomentum) {
  const Vector3d moments(1, 2, 3), wheel(1, 2, 3);
  const FreeBody body(moments.asDiagonal(), {-1, -1, -1}, identity, {.wheel = wheel});
  EXPECT_TRUE(body.momentum().isZero(0.0));
  const Matrix3d expected = so3::exp({-5, -5, -5});
  EXPECT_LE((taylor(body)->sample_at(5).X - expected).norm(), 1e-14);
}

TEST(Interior, AccelerationIsTheDerivativeOfTheRate) {
  for (const ReferenceCase& c : constant_momentum_cases()) {
    const Sample sample = taylor(c.body)->sample_at(1);
    const double h = 1e-4;
    const Vector3d change =
        taylor(c.body)->sample_at(1 + h).omega - taylor(c.body)->sample_at(1 - h).omega;
    EXPECT_LE((angular_acceleration(c.body, sample) - change / (2 * h)).norm(), 1e-7) << c.name;
  }
}

TEST(Interior, GoesBackToWhereItBegan) {
  for (const ReferenceCase& c : constant_momentum_cases()) {
    const Sample end = taylor(c.body)->sample_at(2);
    const FreeBody there =
        c.body.with_start(c.body.rigid_velocity(end.X.transpose() * c.body.momentum()), end.X);
    // The momentum, and hence the energy loss, equals that of the first body to round-off.
    const Sample back = taylor(there, Direction::backward)->sample_at(-2);
    EXPECT_LE((back.X - identity).norm(), 1e-12) << c.name;
  }
}

TEST(Interior, RefusesWhatCannotBe) {
  const Matrix3d inertia = Vector3d(1, 6.5, 7).asDiagonal();
  const auto body = [&](const Matrix3d& I, const Interior& interior) {
    return FreeBody(I, {0, 0, 1}, identity, interior);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {0.0, -1.0, nan, -never}) {
    EXPECT_THROW(body(inertia, {.energy_loss_time = bad}), OutOfRange) << bad;
  }
  // The bound of docs/theory.md is 1.43 s for this body.
  try {
    body(inertia, {.energy_loss_time = 0.5});
    FAIL();
  } catch (const OutOfRange& refused) {
    EXPECT_NEAR(refused.least(), 1.43, 0.005);
  }
  EXPECT_NO_THROW(body(inertia, {.energy_loss_time = 1.44}));
  EXPECT_THROW(body(identity, {.energy_loss_time = 10}), InvalidArgument);
  EXPECT_THROW(body(Vector3d(1, 2, 2).asDiagonal(), {.energy_loss_time = 10}), InvalidArgument);
  EXPECT_NO_THROW(body(Vector3d(2, 2, 3).asDiagonal(), {.energy_loss_time = 1e-3}));
  EXPECT_THROW(body(inertia, {.wheel = {0, nan, 0}}), OutOfRange);
  EXPECT_THROW(body(inertia, {.wheel = {0, 1e200, 0}}), InvalidArgument);
}

/// Series that are expanded together have the bits of series expanded alone.
TEST(Interior, SeriesAreTheSameTogether) {
  const Matrix3d inertia{{3, 0.2, -0.1}, {0.2, 4, 0.3}, {-0.1, 0.3, 5}};
  const FreeBody body(inertia, {1, 2, -0.5}, identity,
                      {.wheel = {0.3, -1, 0.2}, .energy_loss_time = 80});
  const Method& method = find_method("taylor");
  const InteriorSeries series(body, std::get<Taylor>(method.scheme->kind));
  constexpr std::size_t lanes = InteriorSeries::lanes;
  std::array<InteriorSeries, lanes> together{series, series, series, series,
                                             series, series, series, series};
  std::array<InteriorSeries::State, lanes> states;
  std::array<double, lanes> lengths;
  for (std::size_t i = 0; i < lanes; ++i) {
    lengths[i] = i == 0 ? never : 0.02 * static_cast<double>(i);
    states[i] = {
        integrate(body, method, {}, std::array{0.7 * static_cast<double>(i)}).samples[0].X};
  }
  InteriorSeries::expand_together(together, states, lengths);
  for (std::size_t i = 0; i < lanes; ++i) {
    InteriorSeries alone = series;
    alone.expand(states[i], lengths[i]);
    const double h = std::min(lengths[i], 0.1);
    EXPECT_EQ(together[i].at(h).X, alone.at(h).X) << i;
    EXPECT_EQ(together[i].last_terms(h), alone.last_terms(h)) << i;
  }
}

}  // namespace
}  // namespace twrench::motion
