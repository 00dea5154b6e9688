#include "picture/space/camera.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace twrench::picture {
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

/// Half the picture's sides in units of half the shorter one.
Eigen::Array2d half_sides(double aspect) {
  return {std::max(aspect, 1.0), std::max(1 / aspect, 1.0)};
}

/// The extent of the contents of a picture, in units of half its shorter side, y up.
using Extent = Eigen::AlignedBox2d;

/// Returns the extent of the sphere and the points, with a margin.
Extent extent_of(const Framing& framing, std::span<const Vector3d> directions,
                 std::span<const Vector3d> points) {
  const double tan_half = std::tan(framing.field_of_view / 2);
  Framing straight = framing;
  straight.centre.setZero();
  Extent extent;
  for (const Vector3d& direction : directions) {
    straight.direction = direction;
    const Camera camera = frame_sphere(straight);
    const double sine = framing.radius / camera.distance;
    const double silhouette = framing_margin * sine / std::sqrt(1 - sine * sine) / tan_half;
    extent.extend(Eigen::Vector2d::Constant(silhouette));
    extent.extend(Eigen::Vector2d::Constant(-silhouette));
    for (const Vector3d& point : points) {
      const Vector3d p = camera.camera_from_space() * point;
      const double depth = std::max(camera.distance - p.z(), 1e-3 * camera.distance);
      extent.extend(framing_margin / (depth * tan_half) * p.head<2>());
    }
  }
  return extent;
}

}  // namespace

Camera frame_sphere(const Framing& framing) {
  const double half = framing.field_of_view / 2;
  // The cone that touches a sphere of radius r at distance d has the half angle asin(r / d).
  const double distance = framing.distance * framing_margin * framing.radius / std::sin(half);
  const Eigen::Array2d sides = half_sides(framing.aspect);
  const Eigen::Array2d tangents = std::tan(half) * sides;
  // Distant clip planes: a method that leaves SO(3) makes the body grow, and that should be
  // visible.
  Camera camera{look_at_origin(framing.direction, distance),
                perspective(tangents.x(), tangents.y(), 0.05 * distance, 20 * distance), distance};
  camera.projection.col(2).head<2>() = (framing.centre.array() / sides).matrix();  // w = -z
  return camera;
}

Framing fitted(const Framing& framing, std::span<const Vector3d> directions,
               std::span<const Vector3d> points) {
  constexpr int most_attempts = 60;  // a factor of distance shrinks the extent by nearly as much
  const Eigen::Array2d sides = half_sides(framing.aspect);
  Framing result = framing;
  result.distance = 1;
  Extent extent = extent_of(result, directions, points);
  for (int i = 0; i < most_attempts; ++i) {
    const double excess = (extent.sizes().array() / (2 * sides)).maxCoeff();
    if (excess <= 1 + 1e-9) break;
    result.distance *= excess;
    extent = extent_of(result, directions, points);
  }
  result.centre = extent.center();
  return result;
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

Eigen::Matrix3d turned(const Eigen::Matrix3d& from, const Eigen::Matrix3d& to, double share) {
  return Eigen::Quaterniond(from).slerp(share, Eigen::Quaterniond(to)).toRotationMatrix();
}

Camera between(const Camera& from, const Camera& to, double share) {
  const double distance = from.distance * std::pow(to.distance / from.distance, share);
  Matrix4d view = Matrix4d::Identity();
  view.topLeftCorner<3, 3>() = turned(from.camera_from_space(), to.camera_from_space(), share);
  view(2, 3) = -distance;
  return {view, from.projection + share * (to.projection - from.projection), distance};
}

Camera carried(const Camera& camera, const Eigen::Matrix3d& space_from_frame) {
  Camera seen = camera;
  seen.view.topLeftCorner<3, 3>() = camera.camera_from_space() * space_from_frame.transpose();
  return seen;
}

Vector3d direction_of(double azimuth, double elevation) {
  return {std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
          std::cos(azimuth) * std::cos(elevation)};
}

std::vector<Vector3d> directions_along(double azimuth, double elevation, double angle) {
  constexpr int places = 32;
  constexpr double turn = 2 * std::numbers::pi;
  const double seen = std::clamp(angle, -turn, turn);
  std::vector<Vector3d> directions;
  for (int i = 0; i <= (seen == 0 ? 0 : places); ++i) {
    directions.push_back(direction_of(azimuth + seen * i / places, elevation));
  }
  return directions;
}

}  // namespace twrench::picture
