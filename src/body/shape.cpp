#include <twrench/body/shape.h>

#include <cmath>
#include <numbers>
#include <utility>

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

/// The mean squares of the coordinates about the centroid, in the shape's own frame.
struct MeanSquares {
  Vector3d operator()(const Cylinder& c) const {
    const double rr = c.radius * c.radius / 4.0;
    return {rr, rr, c.length * c.length / 12.0};
  }
  Vector3d operator()(const Box& b) const { return b.size.cwiseProduct(b.size) / 12.0; }
  Vector3d operator()(const Ellipsoid& e) const { return e.radii.cwiseProduct(e.radii) / 5.0; }
  Vector3d operator()(const Cone& c) const {
    const auto [a, b] = std::pair(c.radius, c.top_radius);
    const double ends = a * a + a * b + b * b;
    // The integrals of r^4/4 and of z^2 r^2 along the axis over that of r^2.
    const double rr =
        3.0 / 20.0 *
        (a * a * a * a + a * a * a * b + a * a * b * b + a * b * b * b + b * b * b * b) / ends;
    const double along = (a * a + 3.0 * a * b + 6.0 * b * b) / (10.0 * ends);  // from the base
    const double mean = (a * a + 2.0 * a * b + 3.0 * b * b) / (4.0 * ends);
    return {rr, rr, c.length * c.length * (along - mean * mean)};
  }
  Vector3d operator()(const Torus& t) const {
    const double aa = t.tube_radius * t.tube_radius;
    const double rr = (t.radius * t.radius + 0.75 * aa) / 2.0;
    return {rr, rr, aa / 4.0};
  }
  Vector3d operator()(const Capsule& c) const {
    const double r = c.radius, h = c.length;
    const double middle = h / (h + 4.0 / 3.0 * r);  // its share of the volume
    const double rr = middle * r * r / 4.0 + (1.0 - middle) * r * r / 5.0;
    // A hemisphere's mean height above its base is 3r/8, and its mean square r^2/5.
    const double ends = h * h / 4.0 + 3.0 / 8.0 * h * r + r * r / 5.0;
    return {rr, rr, middle * h * h / 12.0 + (1.0 - middle) * ends};
  }
  Vector3d operator()(const Tube& t) const {
    const double rr = (t.radius * t.radius + t.inner_radius * t.inner_radius) / 4.0;
    return {rr, rr, t.length * t.length / 12.0};
  }
  Vector3d operator()(const Mesh&) const { return Vector3d::Zero(); }
};

}  // namespace

double volume(const Shape& shape) {
  return std::visit(
      Overload{
          [](const Cylinder& c) { return pi * c.radius * c.radius * c.length; },
          [](const Box& b) { return b.size.prod(); },
          [](const Ellipsoid& e) { return 4.0 / 3.0 * pi * e.radii.prod(); },
          [](const Cone& c) {
            const auto [a, b] = std::pair(c.radius, c.top_radius);
            return pi / 3.0 * c.length * (a * a + a * b + b * b);
          },
          [](const Torus& t) { return 2.0 * pi * pi * t.radius * t.tube_radius * t.tube_radius; },
          [](const Capsule& c) {
            return pi * c.radius * c.radius * (c.length + 4.0 / 3.0 * c.radius);
          },
          [](const Tube& t) {
            return pi * (t.radius - t.inner_radius) * (t.radius + t.inner_radius) * t.length;
          },
          [](const Mesh& m) { return m.integrals.volume; },
      },
      shape);
}

Vector3d centroid(const Shape& shape) {
  if (const auto* mesh = std::get_if<Mesh>(&shape)) return mesh->integrals.centroid;
  if (const auto* cone = std::get_if<Cone>(&shape)) {
    const auto [a, b] = std::pair(cone->radius, cone->top_radius);
    return {0.0, 0.0, cone->length / 4.0 * (b - a) * (b + a) / (a * a + a * b + b * b)};
  }
  return Vector3d::Zero();
}

Eigen::Matrix3d central_inertia(const Shape& shape, double mass) {
  if (const auto* mesh = std::get_if<Mesh>(&shape)) {
    return mass / mesh->integrals.volume * mesh->integrals.inertia;
  }
  // For a shape symmetric in its coordinate planes, the moment about an axis is the mass times the
  // sum of the mean squares of the two other coordinates.
  const Vector3d s = std::visit(MeanSquares(), shape);
  const Vector3d moments = mass * Vector3d{s.y() + s.z(), s.x() + s.z(), s.x() + s.y()};
  return moments.asDiagonal();
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
