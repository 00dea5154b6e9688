// Measures orders as the slope of the error of X(20) of the T-wrench against the step size, with
// the 25-digit reference.
#include <gtest/gtest.h>
#include <twrench/motion/exact.h>
#include <twrench/motion/stepper.h>

#include <cmath>

#include "motion/every_method.h"
#include "motion/reference.h"
#include "motion/scheme.h"

namespace twrench::motion {
namespace {

/// Returns the Frobenius error of X(20) after `steps` equal steps.
double error_after(const Method& method, int steps) {
  static const ReferenceCase wrench = reference_case("wrench-a");
  const Sample& end = wrench.samples[3];
  Eigen::Matrix3d X = Eigen::Matrix3d::Identity();
  for (int i = 0; i < steps; ++i) X = take_step(wrench.body, method, X, end.t / steps).X;
  return (X - end.X).norm();
}

class MethodOrder : public testing::TestWithParam<Method> {};

// `rk4` and `rkf45` are of second order here, which is not an error of the code. Sections 4.4 and
// 4.5 use one exponential of the averaged stage velocities and thus omit their commutators, the
// first of which is (h^3/12) omega x omega'. Only the tableaus are of order 4 and 5.
TEST_P(MethodOrder, IsTheSlopeOfTheError) {
  const Method& method = GetParam();
  if (method.exact()) GTEST_SKIP() << "no step, no order";
  if (*method.order > 4) GTEST_SKIP() << "no slope over so many steps; see TaylorOrder";
  // The steps range from where the slope is asymptotic to where round-off flattens it.
  const int coarsest = method.order == 1 ? 6400 : 800;
  constexpr double round_off = 1e-12;
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (int i = 0; i < 4; ++i) {
    const int steps = coarsest << i;
    const double error = error_after(method, steps);
    if (error < round_off) break;
    const double x = std::log(1.0 / steps), y = std::log(error);
    n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  ASSERT_GE(n, 2);
  const double slope = (n * sxy - sx * sy) / (n * sxx - sx * sx);
  RecordProperty("slope", std::to_string(slope));
  std::printf("%s: order %.3f\n", std::string(method.name).c_str(), slope);
  // The slope may exceed the order because of the next error term (Fehlberg's first one is small),
  // but is not below it.
  EXPECT_GT(slope, *method.order - 0.1);
  EXPECT_LT(slope, *method.order + 0.3);
}

INSTANTIATE_TEST_SUITE_P(All, MethodOrder, every_method(), method_test_name);

/// The order at which a series is truncated and a step size in s whose error is well above
/// round-off.
class TaylorOrder : public testing::TestWithParam<std::pair<int, double>> {};

// Between round-off and the pole of the motion, such a high order is only visible in single steps,
// whose error scales as h^(order + 1). Low orders test the same recurrence, because it does not
// depend on where it is truncated.
TEST_P(TaylorOrder, IsTheSlopeOfTheLocalError) {
  const auto [order, h] = GetParam();
  Method method = find_method("taylor");
  const Scheme scheme{Taylor{order}};
  method.scheme = &scheme;
  const FreeBody wrench = reference_case("wrench-a").body;
  const auto error = [&](double length) {
    const Step step = take_step(wrench, method, Eigen::Matrix3d::Identity(), length);
    const double truth = (step.X - ExactMotion(wrench).at(length).X).norm();
    EXPECT_GT(step.error, truth) << length;  // the last term exceeds the sum of all omitted terms
    return truth;
  };
  const double slope = std::log2(error(h) / error(h / std::sqrt(2.0))) / 0.5;
  std::printf("taylor cut at %d: order %.3f\n", order, slope - 1);
  EXPECT_GT(slope, order + 0.9);
  EXPECT_LT(slope, order + 1.3);
}

INSTANTIATE_TEST_SUITE_P(Cut, TaylorOrder,
                         testing::Values(std::pair{2, 0.5}, std::pair{4, 0.5}, std::pair{8, 1.0},
                                         std::pair{10, 1.7}, std::pair{20, 4.4}));

// The values published for the printed RK4 and RKF45 (its 5th-order row aside) at 100 to 800 steps.
TEST(MethodError, OfThePrintedRungeKuttaMethods) {
  const double expected[] = {6.1e-3, 1.1e-3, 2.4e-4, 5.8e-5};
  for (int i = 0; i < 4; ++i) {
    EXPECT_NEAR(error_after(find_method("rk4"), 100 << i) / expected[i], 1, 0.05);
    EXPECT_NEAR(error_after(find_method("rkf45"), 100 << i) / expected[i], 1, 0.1);
  }
}

}  // namespace
}  // namespace twrench::motion
