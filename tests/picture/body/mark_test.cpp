#include "picture/body/mark.h"

#include <gtest/gtest.h>
#include <twrench/body/mass_properties.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "picture/body/bounding_radius.h"
#include "picture/shapes/shapes.h"
#include "picture/t_wrench.h"

namespace twrench::picture {
namespace {

using Eigen::Vector3d;
using Parts = std::vector<body::Part>;

enum class Paint { none, black, white };

Paint paint_at(const MarkFromBody& mark, const Vector3d& place) {
  const auto value = [&](std::size_t i) {
    return mark[i].x * place.x() + mark[i].y * place.y() + mark[i].z * place.z() + mark[i].w;
  };
  if (value(2) < std::abs(value(1))) return Paint::none;
  return value(0) > 0 ? Paint::white : Paint::black;
}

std::optional<MarkFromBody> mark_of(const Parts& parts) {
  return mark_from_body(parts, std::vector(parts.size(), 0UL),
                        body::principal_axes(body::mass_properties(parts).inertia));
}

bool is_inside(const Parts& parts, const Vector3d& place) {
  return std::ranges::any_of(parts, [&](const body::Part& part) {
    const Vector3d local = part.body_from_part.transpose() * (place - part.position);
    return std::visit([&](const auto& solid) { return holds(solid, local, 0); }, part.shape);
  });
}

/// Points inside of the parts.
std::vector<Vector3d> points_of(const Parts& parts) {
  constexpr int steps = 60;
  const double radius = bounding_radius(parts);
  std::vector<Vector3d> points;
  for (int i = 0; i < steps * steps * steps; ++i) {
    const Vector3d place(i % steps, i / steps % steps, i / (steps * steps));
    const Vector3d point =
        radius * ((place + Vector3d::Constant(0.5)) * 2 / steps - Vector3d::Ones());
    if (is_inside(parts, point)) points.push_back(point);
  }
  return points;
}

body::Part solid(const body::Shape& shape) {
  return {shape, 1, Vector3d::Zero(), Eigen::Matrix3d::Identity()};
}

/// Bodies that half a turn about each coordinate axis maps to themselves.
std::vector<Parts> symmetric_bodies(double size) {
  const auto box = [&](double a, double b, double c) {
    return solid(body::Box{size * Vector3d(a, b, c)});
  };
  return {{box(1, 2, 3)},
          {box(4, 6, 0.5)},
          {box(2, 2, 3)},
          {box(2, 2, 0.4)},
          {box(2, 2, 2)},
          {box(6, 1, 1), box(1, 4, 1)},
          {solid(body::Cylinder{size, 7 * size})},
          {solid(body::Cylinder{3 * size, size})},
          {solid(body::Torus{2 * size, 0.7 * size})},
          {solid(body::Ellipsoid{size * Vector3d(1, 1, 1)})},
          {solid(body::Ellipsoid{size * Vector3d(1, 2, 3)})}};
}

TEST(Mark, ChangesWithEachHalfTurnOfABodyThatLooksTheSame) {
  for (const double size : {1e-6, 1.0, 1e6}) {
    int number = 0;
    for (const Parts& parts : symmetric_bodies(size)) {
      const auto mark = mark_of(parts);
      ASSERT_TRUE(mark) << number;
      const std::vector<Vector3d> points = points_of(parts);
      ASSERT_GT(points.size(), 1000U);
      for (const Vector3d& axis : {Vector3d(1, 0, 0), Vector3d(0, 1, 0), Vector3d(0, 0, 1)}) {
        const auto changes = [&](const Vector3d& point) {
          return paint_at(*mark, point) != paint_at(*mark, 2 * axis.dot(point) * axis - point);
        };
        const auto changed = static_cast<double>(std::ranges::count_if(points, changes));
        EXPECT_GT(changed, 0.03 * static_cast<double>(points.size()))
            << "body " << number << " about " << axis.transpose();
      }
      ++number;
    }
  }
}

TEST(Mark, LeavesMostOfTheBodyUnpainted) {
  for (const Parts& parts : symmetric_bodies(1)) {
    const MarkFromBody mark = mark_of(parts).value();
    const std::vector<Vector3d> points = points_of(parts);
    const auto is_painted = [&](const Vector3d& p) { return paint_at(mark, p) != Paint::none; };
    const auto painted = static_cast<double>(std::ranges::count_if(points, is_painted));
    EXPECT_LT(painted, 0.4 * static_cast<double>(points.size()));
  }
}

TEST(Mark, IsAtTheEndOfTheAxisThatIsReversed) {
  const MarkFromBody box = mark_of({solid(body::Box{{4, 6, 2}})}).value();  // x is intermediate
  EXPECT_EQ(paint_at(box, {1.9, 2.9, 0}), Paint::white);
  EXPECT_EQ(paint_at(box, {1.9, -2.9, 0}), Paint::black);
  EXPECT_EQ(paint_at(box, {0.9, 2.9, 0}), Paint::none);
  EXPECT_EQ(paint_at(box, {-1.9, 2.9, 0}), Paint::none);
}

TEST(Mark, IsNotOnBodiesThatShowHowTheyTurn) {
  EXPECT_FALSE(mark_of(t_wrench().body.parts));
  const Parts two{solid(body::Box{{1, 2, 3}}), solid(body::Cylinder{0.2, 5})};
  EXPECT_TRUE(mark_of(two));
  Parts bent = two;
  bent[1].position = {0.2, 0.5, 1};
  const Vector3d centre = body::mass_properties(bent).centre_of_mass;
  for (body::Part& part : bent) part.position -= centre;
  EXPECT_FALSE(mark_of(bent));
}

}  // namespace
}  // namespace twrench::picture
