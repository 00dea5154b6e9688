#include "render/space/camera.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace twrench::render {
namespace {

using Eigen::Matrix4d;
using Eigen::Vector3d;

constexpr double framing_margin = 1.08;  // around the sphere: 4 % of the picture on each side

Matrix4d look_at_origin(const Vector3d& direction, double distance) {
  const Vector3d back = direction.normalized();
  // At an elevation of pi/2, as close as a double gets, 6e-17 remains to determine the azimuth.
  const bool from_the_pole = std::hypot(back.x(), back.z()) < 1e-18;
  const Vector3d up = from_the_pole ? Vector3d(-std::copysign(1.0, back.y()) * Vector3d::UnitZ())
                                    : Vector3d::UnitY();
  const Vector3d right = up.cross(back).normalized();
  Matrix4d view = Matrix4d::Identity();
  view.row(0).head<3>() = right;
  view.row(1).head<3>() = back.cross(right);
  view.row(2).head<3>() = back;
  view(2, 3) = -distance;
  return view;
}

/// OpenGL's perspective matrix (clip z from -w to w), from the tangents of half the fields of view.
Matrix4d perspective(double tan_x, double tan_y, double near, double far) {
  Matrix4d projection = Matrix4d::Zero();
  projection(0, 0) = 1 / tan_x;
  projection(1, 1) = 1 / tan_y;
  projection(2, 2) = -(far + near) / (far - near);
  projection(2, 3) = -2 * far * near / (far - near);
  projection(3, 2) = -1;
  return projection;
}

}  // namespace

Camera frame_sphere(const Framing& framing) {
  const double half = framing.field_of_view / 2;
  // The cone that touches a sphere of radius r at distance d has the half angle asin(r / d).
  const double distance = framing.distance * framing_margin * framing.radius / std::sin(half);
  const double tan_x = std::tan(half) * std::max(framing.aspect, 1.0);
  const double tan_y = std::tan(half) * std::max(1 / framing.aspect, 1.0);
  // Distant clip planes: a method that leaves SO(3) makes the body grow, and that should be
  // visible.
  return {look_at_origin(framing.direction, distance),
          perspective(tan_x, tan_y, 0.05 * distance, 20 * distance), distance};
}

double distance_to_see(const Framing& framing, std::span<const Vector3d> points) {
  Framing nearest = framing;
  nearest.distance = 1;
  const Camera camera = frame_sphere(nearest);
  double distance = camera.distance;
  for (const Vector3d& point : points) {
    const Eigen::Array3d p = camera.camera_from_space() * point;
    const double across = std::abs(p.x()) * camera.projection(0, 0);
    const double upward = std::abs(p.y()) * camera.projection(1, 1);
    distance = std::max(distance, p.z() + framing_margin * std::max(across, upward));
  }
  return distance / camera.distance;
}

Eigen::Vector2d pixel_of(const Camera& camera, const image::Area& pane, const Vector3d& place) {
  const Eigen::Vector4d clip = camera.projection * camera.view * place.homogeneous();
  return {pane.x + (0.5 + 0.5 * clip.x() / clip.w()) * pane.width,
          pane.y + (0.5 - 0.5 * clip.y() / clip.w()) * pane.height};
}

Camera widened(const Camera& camera, const image::Area& focus, const image::Area& pane) {
  Camera wide = camera;
  const double scale_x = static_cast<double>(focus.width) / pane.width;
  const double scale_y = static_cast<double>(focus.height) / pane.height;
  const double middle_x = (2.0 * (focus.x - pane.x) + focus.width) / pane.width - 1;
  const double middle_y = 1 - (2.0 * (focus.y - pane.y) + focus.height) / pane.height;
  const Eigen::RowVector4d w = camera.projection.row(3);
  wide.projection.row(0) = scale_x * camera.projection.row(0) + middle_x * w;
  wide.projection.row(1) = scale_y * camera.projection.row(1) + middle_y * w;
  return wide;
}

Vector3d direction_of(double azimuth, double elevation) {
  return {std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
          std::cos(azimuth) * std::cos(elevation)};
}

}  // namespace twrench::render
