#include "page/shadow_balls.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numeric>

namespace twrench::page {
namespace {

using picture::Ball;

body::Part ball_at(double x, double y) {
  return {body::Ellipsoid{{0.1, 0.1, 0.1}}, 1, {x, y, 0}, Eigen::Matrix3d::Identity()};
}

/// The sum of the squared radii.
double cross_section(const std::vector<Ball>& balls) {
  return std::transform_reduce(balls.begin(), balls.end(), 0.0, std::plus<>(),
                               [](const Ball& ball) { return ball.radius * ball.radius; });
}

// A shader has room for 64: the farthest ball is not merged with others.
TEST(ReducedShadowBalls, AreMergedWithTheClosest) {
  std::vector<body::Part> parts;
  for (int i = 0; i < 99; ++i) parts.push_back(ball_at(0.3 * (i % 10), 0.3 * (i / 10)));
  parts.push_back(ball_at(50, 0));
  const std::vector<Ball> all = picture::shadow_balls(parts);
  const std::vector<Ball> balls = reduced_shadow_balls(parts);
  EXPECT_EQ(balls.size(), 64U);
  EXPECT_NEAR(cross_section(balls), cross_section(all), 1e-12);
  EXPECT_EQ(std::ranges::count_if(balls, [](const Ball& ball) { return ball.centre.x() > 3; }), 1);
  const auto farthest =
      std::ranges::max_element(balls, {}, [](const Ball& ball) { return ball.centre.x(); });
  EXPECT_NEAR(farthest->centre.x(), 50, 1e-12);
  EXPECT_LT(std::ranges::max(balls, {}, &Ball::radius).radius, 3 * farthest->radius);
}

}  // namespace
}  // namespace twrench::page
