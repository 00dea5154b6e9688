// The arrows of a draw list: cones whose silhouettes are found exactly.
#include <twrench/body/shape.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/overlay/draw_list.h"

namespace twrench::render {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::Vector4d;

constexpr double head_length = 5.5, head_radius = 2.4;  // of an arrow, in radii of its shaft
constexpr std::uint32_t around_arrow = 28;

}  // namespace

/// The side of a cone, or of a part of one, with its axis along z of its frame.
struct DrawList::Cone {
  Matrix3d frame;
  Vector3d from;  ///< centre of its base
  double length;
  double base, top;  ///< radii

  Vector3d at(double angle, double height, double radius) const {
    return from + frame * Vector3d(radius * std::cos(angle), radius * std::sin(angle), height);
  }
  /// Outward unit normal at that angle.
  Vector3d normal(double angle) const {
    const Vector3d n(length * std::cos(angle), length * std::sin(angle), base - top);
    return frame * n.normalized();
  }
};

void DrawList::cone(const Cone& cone, const Ink& ink) {
  const auto first = static_cast<std::uint32_t>(vertices_.size());
  for (const auto& [height, radius] : {std::pair(0.0, cone.base), {cone.length, cone.top}}) {
    const double scale = pixels(cone.from + height * cone.frame.col(2));
    const double shrunk = std::max(radius - (scale > 0 ? 0.5 / scale : 0.0), 0.0);
    for (std::uint32_t i = 0; i < around_arrow; ++i) {
      const double angle = 2 * std::numbers::pi * i / around_arrow;
      add_lit(cone.at(angle, height, shrunk), cone.normal(angle), ink);
    }
  }
  band(first, first + around_arrow, around_arrow);
  add_side_edge_quads(cone, ink);
}

/// The base of a cone, seen from outside.
void DrawList::base(const Cone& cone, const Ink& ink) {
  const double scale = pixels(cone.from);
  const double shrunk = std::max(cone.base - (scale > 0 ? 0.5 / scale : 0.0), 0.0);
  const std::uint32_t middle = add_lit(cone.from, -cone.frame.col(2), ink);
  for (std::uint32_t i = 0; i < around_arrow; ++i) {
    const double angle = 2 * std::numbers::pi * i / around_arrow;
    add_lit(cone.at(angle, 0, shrunk), -cone.frame.col(2), ink);
    indices_.insert(indices_.end(), {middle, middle + 1 + i, middle + 1 + (i + 1) % around_arrow});
  }
  add_rim_edge_quads(cone, ink);
}

/// The silhouette of the side consists of the two lines whose normal n is perpendicular to the line
/// of sight: n . (eye - p) = 0, in the cone's frame cos(a) e_x + sin(a) e_y = base - slope e_z.
void DrawList::add_side_edge_quads(const Cone& cone, const Ink& ink) {
  const Vector3d eye = cone.frame.transpose() * (eye_ - cone.from);
  const double slope = (cone.base - cone.top) / cone.length;
  const double cosine = (cone.base - slope * eye.z()) / std::hypot(eye.x(), eye.y());
  if (!(std::abs(cosine) < 1)) return;  // seen end-on
  const Vector4d inside = clip(cone.from + 0.5 * cone.length * cone.frame.col(2));
  for (const double sign : {-1.0, 1.0}) {
    const double angle = std::atan2(eye.y(), eye.x()) + sign * std::acos(cosine);
    const Vector3d normal = cone.normal(angle);
    const std::uint32_t low = add_lit(cone.at(angle, 0, cone.base), normal, ink);
    const std::uint32_t high = add_lit(cone.at(angle, cone.length, cone.top), normal, ink);
    add_edge_quad(low, high, inside, edge_quad_indices_);
  }
}

/// The rim of the base is part of the silhouette if exactly one of base and side is visible.
void DrawList::add_rim_edge_quads(const Cone& cone, const Ink& ink) {
  const Vector3d& axis = cone.frame.col(2);
  const bool base_seen = axis.dot(eye_ - cone.from) < 0;
  const Vector4d inside = clip(cone.from);
  for (std::uint32_t i = 0; i < around_arrow; ++i) {
    const double angle = 2 * std::numbers::pi * i / around_arrow;
    const double next = 2 * std::numbers::pi * (i + 1) / around_arrow;
    const Vector3d normal = cone.normal(0.5 * (angle + next));
    const Vector3d place = cone.at(angle, 0, cone.base);
    if ((normal.dot(eye_ - place) > 0) == base_seen) continue;
    const Vector3d shown = base_seen ? Vector3d(-axis) : normal;
    const std::uint32_t first = add_lit(place, shown, ink);
    const std::uint32_t second = add_lit(cone.at(next, 0, cone.base), shown, ink);
    add_edge_quad(first, second, inside, edge_quad_indices_);
  }
}

void DrawList::arrow(const Vector3d& from, const Vector3d& to, double radius, const Ink& ink) {
  const double length = (to - from).norm();
  if (!(length > 0)) return;
  begin_thing();
  const double scale = std::min(1.0, length / (head_length * radius));
  const double head = head_length * radius * scale, shaft = length - head;
  const Matrix3d frame = body::frame_with_z_along(to - from);
  const Cone tip{frame, from + shaft * frame.col(2), head, head_radius * radius * scale, 0};
  if (shaft > 0) cone({frame, from, shaft, radius, radius}, ink);
  cone(tip, ink);
  base(tip, ink);
}

}  // namespace twrench::render
