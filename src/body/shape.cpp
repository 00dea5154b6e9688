#include <twrench/body/shape.h>

#include <cmath>
#include <numbers>

namespace twrench::body {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

/// Combines several lambdas into one visitor.
template <typename... F>
struct Overload : F... {
  using F::operator()...;
};
template <typename... F>
Overload(F...) -> Overload<F...>;  // clang 14 does not deduce it

}  // namespace

double volume(const Shape& shape) {
  return std::visit(Overload{
                        [](const Cylinder& c) { return pi * c.radius * c.radius * c.length; },
                        [](const Box& b) { return b.size.prod(); },
                        [](const Ellipsoid& e) { return 4.0 / 3.0 * pi * e.radii.prod(); },
                    },
                    shape);
}

Vector3d central_moments(const Shape& shape, double mass) {
  // For a shape symmetric in its coordinate planes, the moment about an axis is the mass times the
  // sum of the mean squares of the two other coordinates.
  const auto from_mean_squares = [mass](const Vector3d& s) {
    return Vector3d{mass * (s.y() + s.z()), mass * (s.x() + s.z()), mass * (s.x() + s.y())};
  };
  return std::visit(
      Overload{
          [&](const Cylinder& c) {
            const double rr = c.radius * c.radius / 4.0;
            return from_mean_squares({rr, rr, c.length * c.length / 12.0});
          },
          [&](const Box& b) { return from_mean_squares(b.size.cwiseProduct(b.size) / 12.0); },
          [&](const Ellipsoid& e) {
            return from_mean_squares(e.radii.cwiseProduct(e.radii) / 5.0);
          },
      },
      shape);
}

double bounding_radius(const Shape& shape) {
  return std::visit(Overload{
                        [](const Cylinder& c) { return std::hypot(c.radius, c.length / 2.0); },
                        [](const Box& b) { return b.size.norm() / 2.0; },
                        [](const Ellipsoid& e) { return e.radii.maxCoeff(); },
                    },
                    shape);
}

Eigen::Matrix3d frame_with_z_along(const Vector3d& axis) {
  const Vector3d n = axis.stableNormalized();  // The square of its length may underflow.
  const double sign = std::copysign(1.0, n.z());
  const double a = -1.0 / (sign + n.z());
  const double b = n.x() * n.y() * a;
  Eigen::Matrix3d frame;
  frame.col(0) = Vector3d{1.0 + sign * n.x() * n.x() * a, sign * b, -sign * n.x()};
  frame.col(1) = Vector3d{b, sign + n.y() * n.y() * a, -n.y()};
  frame.col(2) = n;
  return frame;
}

}  // namespace twrench::body
