// The arrows of a draw list: cones whose silhouettes are found exactly.
#include <twrench/body/shape.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "picture/look/material.h"
#include "picture/overlay/draw_list.h"

namespace twrench::picture {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::Vector4d;

// Numbers of facets: outlines are seen only beside the arrows, and ghosts are faint.
constexpr std::uint32_t around_arrow = 28, around_outline = 16, around_ghost = 10;
constexpr double outline_width = 0.3, least_outline = 1;  // radii of the shaft, pixels
constexpr double outline_opacity = 0.9;

/// Returns black or white, whichever has the higher contrast (WCAG 2.1, "contrast ratio").
Color contrasting(const Color& color) {
  const double luminance = 0.2126 * linear_from_srgb(color.red) +
                           0.7152 * linear_from_srgb(color.green) +
                           0.0722 * linear_from_srgb(color.blue);
  constexpr double even = 0.179;  // (even + 0.05)^2 = 0.05 * 1.05
  return luminance > even ? Color{8, 9, 12} : Color{255, 255, 255};
}

}  // namespace

/// The side of a cone, or of a part of one, with its axis along z of its frame.
struct DrawList::Cone {
  Matrix3d frame;
  Vector3d from;  ///< centre of its base
  double length;
  double base, top;  ///< radii
  Ink ink;
  std::uint32_t around;  ///< facets
  bool shaded;

  Vector3d at(double angle, double height, double radius) const {
    return from + frame * Vector3d(radius * std::cos(angle), radius * std::sin(angle), height);
  }
  /// Outward unit normal at that angle.
  Vector3d normal(double angle) const {
    const Vector3d n(length * std::cos(angle), length * std::sin(angle), base - top);
    return frame * n.normalized();
  }
  /// Returns the cone whose faces lie `by` outside of this one's.
  Cone grown(double by, const Ink& flat) const {
    const double slant = std::hypot(length, base - top);
    const double wider = by * slant / length, slope = by * (base - top) / length;
    return {frame,
            from - by * frame.col(2),
            length + 2 * by,
            base + wider + slope,
            top + wider - slope,
            flat,
            around_outline,
            false};
  }
};

std::uint32_t DrawList::add_on(const Cone& cone, const Vector3d& place, const Vector3d& normal) {
  return cone.shaded ? add_lit(place, normal, cone.ink) : add(clip(place), cone.ink, no_edge);
}

void DrawList::side(const Cone& cone, Triangles& triangles) {
  const auto first = static_cast<std::uint32_t>(vertices_.size());
  for (const auto& [height, radius] : {std::pair(0.0, cone.base), {cone.length, cone.top}}) {
    const double scale = pixels(cone.from + height * cone.frame.col(2));
    const double shrunk = std::max(radius - (scale > 0 ? 0.5 / scale : 0.0), 0.0);
    for (std::uint32_t i = 0; i < cone.around; ++i) {
      const double angle = 2 * std::numbers::pi * i / cone.around;
      add_on(cone, cone.at(angle, height, shrunk), cone.normal(angle));
    }
  }
  band(first, first + cone.around, cone.around, triangles.faces);
  add_side_edge_quads(cone, triangles.edge_quads);
}

/// The base of a cone, seen from outside.
void DrawList::base(const Cone& cone, Triangles& triangles) {
  const double scale = pixels(cone.from);
  const double shrunk = std::max(cone.base - (scale > 0 ? 0.5 / scale : 0.0), 0.0);
  const std::uint32_t middle = add_on(cone, cone.from, -cone.frame.col(2));
  for (std::uint32_t i = 0; i < cone.around; ++i) {
    const double angle = 2 * std::numbers::pi * i / cone.around;
    add_on(cone, cone.at(angle, 0, shrunk), -cone.frame.col(2));
    triangles.faces.insert(triangles.faces.end(),
                           {middle, middle + 1 + (i + 1) % cone.around, middle + 1 + i});
  }
  add_rim_edge_quads(cone, triangles.edge_quads);
}

/// The silhouette of the side consists of the two lines whose normal n is perpendicular to the line
/// of sight: n . (eye - p) = 0, in the cone's frame cos(a) e_x + sin(a) e_y = base - slope e_z.
void DrawList::add_side_edge_quads(const Cone& cone, std::vector<std::uint32_t>& indices) {
  const Vector3d eye = cone.frame.transpose() * (eye_ - cone.from);
  const double slope = (cone.base - cone.top) / cone.length;
  const double cosine = (cone.base - slope * eye.z()) / std::hypot(eye.x(), eye.y());
  if (!(std::abs(cosine) < 1)) return;  // seen end-on
  const Vector4d inside = clip(cone.from + 0.5 * cone.length * cone.frame.col(2));
  for (const double sign : {-1.0, 1.0}) {
    const double angle = std::atan2(eye.y(), eye.x()) + sign * std::acos(cosine);
    const Vector3d normal = cone.normal(angle);
    const std::uint32_t low = add_on(cone, cone.at(angle, 0, cone.base), normal);
    const std::uint32_t high = add_on(cone, cone.at(angle, cone.length, cone.top), normal);
    add_edge_quad(low, high, inside, indices);
  }
}

/// The rim of the base is part of the silhouette if exactly one of base and side is visible.
void DrawList::add_rim_edge_quads(const Cone& cone, std::vector<std::uint32_t>& indices) {
  const Vector3d& axis = cone.frame.col(2);
  const bool base_seen = axis.dot(eye_ - cone.from) < 0;
  const Vector4d inside = clip(cone.from);
  for (std::uint32_t i = 0; i < cone.around; ++i) {
    const double angle = 2 * std::numbers::pi * i / cone.around;
    const double next = 2 * std::numbers::pi * (i + 1) / cone.around;
    const Vector3d normal = cone.normal(0.5 * (angle + next));
    const Vector3d place = cone.at(angle, 0, cone.base);
    if ((normal.dot(eye_ - place) > 0) == base_seen) continue;
    const Vector3d shown = base_seen ? Vector3d(-axis) : normal;
    const std::uint32_t first = add_on(cone, place, shown);
    const std::uint32_t second = add_on(cone, cone.at(next, 0, cone.base), shown);
    add_edge_quad(first, second, inside, indices);
  }
}

void DrawList::arrow(const Vector3d& from, const Vector3d& to, double radius, const Ink& ink,
                     double nearer) {
  arrow(std::array{from, to}, radius, ink, nearer);
}

void DrawList::arrow(std::span<const Vector3d> path, double radius, const Ink& ink, double nearer) {
  double length = 0;
  for (std::size_t i = 1; i < path.size(); ++i) length += (path[i] - path[i - 1]).norm();
  if (!(length > 0)) return;
  const double head_length = std::min(arrow_head_length * radius, length);
  const double scale = head_length / (arrow_head_length * radius);
  double shaft = length - head_length;  // exactly 0 for an arrow without a shaft
  std::vector<Cone> stems;
  Vector3d neck = path.front();
  for (std::size_t i = 1; i < path.size() && shaft > 0; ++i) {
    const Vector3d way = path[i] - path[i - 1];
    const double piece = std::min(way.norm(), shaft);
    if (!(piece > 0)) continue;
    const Matrix3d frame = body::frame_with_z_along(way);
    stems.push_back({frame, path[i - 1], piece, radius, radius, ink, around_arrow, true});
    neck = path[i - 1] + piece * frame.col(2);
    shaft -= piece;
  }
  const Vector3d head = path.back() - neck;
  const Cone tip{body::frame_with_z_along(head),
                 neck,
                 head.norm(),
                 arrow_head_radius * radius * scale,
                 0,
                 ink,
                 around_arrow,
                 true};
  begin_thing();
  nearer_ = nearer;
  for (const Cone& stem : stems) side(stem, items_);
  side(tip, items_);
  base(tip, items_);
  if (const double size = pixels(neck); size > 0) {
    add_outline(stems, tip, scale * std::max(outline_width * radius, least_outline / size));
    add_ghost(stems, tip);
  }
  nearer_ = 0;
}

void DrawList::add_outline(std::span<const Cone> stems, const Cone& tip, double width) {
  const Ink outline{contrasting(tip.ink.color), outline_opacity * tip.ink.opacity};
  for (const Cone& stem : stems) side(stem.grown(width, outline), outlines_);
  side(tip.grown(width, outline), outlines_);
  base(tip.grown(width, outline), outlines_);
}

/// The stem is a line narrowed by its ramp, which would otherwise add to the edges of the visible
/// part.
void DrawList::add_ghost(std::span<const Cone> stems, const Cone& tip) {
  std::vector<Point> line;
  const auto add_point = [&](const Cone& stem, double along) {
    const Vector3d axis = stem.from + along * stem.frame.col(2);
    const Vector3d place = axis + stem.base * (eye_ - axis).normalized();  // the side that is seen
    line.push_back({place, std::max(2 * stem.base * pixels(place) - 1, 0.0), stem.ink});
  };
  for (const Cone& stem : stems) add_point(stem, 0);
  if (!stems.empty() && stems.back().length > stems.back().base) {
    add_point(stems.back(), stems.back().length - stems.back().base);
  }
  if (line.size() > 1) add_line(line, ghosts_.faces);
  Cone plain = tip;
  plain.around = around_ghost;
  side(plain, ghosts_);
  base(plain, ghosts_);
}

}  // namespace twrench::picture
