#include "page/shadow_balls.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <random>

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

/// Merges the two balls whose cross-sections have the least second moment about their common mean.
void merge_two(std::vector<Ball>& balls) {
  const auto section = [](const Ball& ball) { return ball.radius * ball.radius; };
  const auto cost = [&](const Ball& a, const Ball& b) {
    const double share = section(a) * section(b) / (section(a) + section(b));
    return share * (a.centre - b.centre).squaredNorm();
  };
  std::size_t first = 0, second = 1;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    for (std::size_t k = i + 1; k < balls.size(); ++k) {
      if (cost(balls[i], balls[k]) < cost(balls[first], balls[second])) first = i, second = k;
    }
  }
  const Ball a = balls[first], b = balls[second];
  const double sum = section(a) + section(b);
  balls[first] = {(section(a) * a.centre + section(b) * b.centre) / sum, std::sqrt(sum)};
  balls.erase(balls.begin() + static_cast<std::ptrdiff_t>(second));
}

TEST(ReducedShadowBalls, AreThoseOfASearchThroughAllPairs) {
  std::vector<body::Part> parts;
  std::mt19937 dice(1);
  std::uniform_real_distribution<double> place(0, 10);
  for (int i = 0; i < 150; ++i) parts.push_back(ball_at(place(dice), place(dice)));
  std::vector<Ball> expected = picture::shadow_balls(parts);
  while (expected.size() > 64) merge_two(expected);
  const std::vector<Ball> balls = reduced_shadow_balls(parts);
  ASSERT_EQ(balls.size(), expected.size());
  for (std::size_t i = 0; i < balls.size(); ++i) {
    EXPECT_NEAR((balls[i].centre - expected[i].centre).norm(), 0, 1e-12) << i;
    EXPECT_NEAR(balls[i].radius, expected[i].radius, 1e-12) << i;
  }
}

}  // namespace
}  // namespace twrench::page
