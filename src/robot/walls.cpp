#include <cmath>
#include <numbers>

#include "robot/geometry.h"

namespace twrench::robot {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

/// A surface of area `area` centred at the origin, with the integrals of x^2, y^2 and z^2.
body::SolidIntegrals wall(double area, const Vector3d& second) {
  const Vector3d moments = Vector3d::Constant(second.sum()) - second;
  return {area, Vector3d::Zero(), moments.asDiagonal()};
}

body::SolidIntegrals box_wall(const Vector3d& size) {
  Vector3d second = Vector3d::Zero();
  double area = 0.0;
  for (int axis = 0; axis < 3; ++axis) {  // the two faces across this axis
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    const double faces = 2.0 * size[a] * size[b];
    area += faces;
    second[axis] += faces * size[axis] * size[axis] / 4;
    second[a] += faces * size[a] * size[a] / 12;
    second[b] += faces * size[b] * size[b] / 12;
  }
  return wall(area, second);
}

body::SolidIntegrals cylinder_wall(double r, double length) {
  const double side = 2 * pi * r * length, ends = 2 * pi * r * r;
  const double across = side * r * r / 2 + ends * r * r / 4;
  return wall(side + ends,
              {across, across, side * length * length / 12 + ends * length * length / 4});
}

body::SolidIntegrals capsule_wall(double r, double length) {
  const double side = 2 * pi * r * length, ends = 4 * pi * r * r;
  // The coordinate z of a hemisphere is uniform between length/2 and length/2 + r (Archimedes).
  const double h = length / 2;
  const double along = side * length * length / 12 + ends * (h * h + h * r + r * r / 3);
  const double across = side * r * r / 2 + ends * r * r / 3;
  return wall(side + ends, {across, across, along});
}

}  // namespace

std::optional<body::SolidIntegrals> wall_integrals(const body::Shape& shape) {
  if (const auto* box = std::get_if<body::Box>(&shape)) return box_wall(box->size);
  if (const auto* cylinder = std::get_if<body::Cylinder>(&shape))
    return cylinder_wall(cylinder->radius, cylinder->length);
  if (const auto* capsule = std::get_if<body::Capsule>(&shape))
    return capsule_wall(capsule->radius, capsule->length);
  if (const auto* ball = std::get_if<body::Ellipsoid>(&shape);
      ball && ball->radii.isConstant(ball->radii[0])) {
    const double r = ball->radii[0], area = 4 * pi * r * r;
    return wall(area, Vector3d::Constant(area * r * r / 3));
  }
  return std::nullopt;
}

}  // namespace twrench::robot
