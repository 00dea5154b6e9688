#include "picture/overlay/draw_list.h"

#include <twrench/body/shape.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace twrench::picture {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector4d;

constexpr std::uint32_t around_disc = 96;

glm::vec4 paint_of(const Ink& ink) {
  const double scale = ink.opacity / 255;
  const Vector4d p(scale * ink.color.red, scale * ink.color.green, scale * ink.color.blue,
                   ink.opacity);
  const Eigen::Vector4f f = p.cast<float>();
  return {f.x(), f.y(), f.z(), f.w()};
}

/// Lights the ink: a light from above the camera's right shoulder, a weaker one from its left, and
/// a highlight. It is less glossy than the body's metal. All vectors are unit vectors in camera
/// axes.
Ink lit(const Ink& ink, const Vector3d& normal, const Vector3d& to_eye) {
  static const Vector3d key = Vector3d(0.45, 0.75, 0.5).normalized();
  static const Vector3d fill = Vector3d(-0.8, 0.1, 0.6).normalized();
  const double light =
      0.72 + 0.3 * std::max(normal.dot(key), 0.0) + 0.12 * std::max(normal.dot(fill), 0.0);
  const double gleam = 0.35 * std::pow(std::max(normal.dot((key + to_eye).normalized()), 0.0), 40);
  const auto channel = [&](int value) {
    const double base = std::min(light * value, 255.0);
    return static_cast<int>(std::lround(base + gleam * (255 - base)));
  };
  return {{channel(ink.color.red), channel(ink.color.green), channel(ink.color.blue)}, ink.opacity};
}

/// Returns the ink that looks like `top` over `ground`.
Ink over(const Ink& top, const Ink& ground) {
  const double behind = (1 - top.opacity) * ground.opacity, opacity = top.opacity + behind;
  if (!(opacity > 0)) return {top.color, 0};
  const auto channel = [&](int of_top, int of_ground) {
    return static_cast<int>(std::lround((top.opacity * of_top + behind * of_ground) / opacity));
  };
  return {{channel(top.color.red, ground.color.red), channel(top.color.green, ground.color.green),
           channel(top.color.blue, ground.color.blue)},
          opacity};
}

}  // namespace

void DrawList::begin(const Camera& camera, const image::Area& pane) {
  clip_from_space_ = camera.projection * camera.view;
  camera_from_space_ = camera.camera_from_space();
  eye_ = -camera_from_space_.transpose() * camera.view.col(3).head<3>();
  half_size_ = 0.5 * Vector2d(pane.width, pane.height);
  scale_ = camera.projection(1, 1) * half_size_.y();
  // At depth w, z / w in clip space is P23 / w plus a constant, and the pane's height spans
  // 2 w / P11.
  clip_z_nearer_ = 2 * camera.projection(2, 3) / camera.projection(1, 1);
  vertices_.clear();
  things_.clear();
  for (Triangles* triangles : {&items_, &outlines_, &ghosts_}) {
    triangles->faces.clear();
    triangles->edge_quads.clear();
  }
}

Vector4d DrawList::clip(const Vector3d& place) const {
  Vector4d clip = clip_from_space_ * place.homogeneous();
  if (nearer_ == 0) return clip;
  const Vector3d moved = place + nearer_ * (eye_ - place).normalized();
  const Vector4d depth = clip_from_space_ * moved.homogeneous();
  if (depth.w() > 0) clip.z() = depth.z() / depth.w() * clip.w();
  return clip;
}

double DrawList::pixels(const Vector3d& place) const {
  const double depth = clip_from_space_.row(3) * place.homogeneous();
  return depth > 0 ? scale_ / depth : 0;
}

std::uint32_t DrawList::add(const Vector4d& clip, const Ink& ink, const glm::vec3& edge) {
  const Eigen::Vector4f c = clip.cast<float>();
  vertices_.push_back({{c.x(), c.y(), c.z(), c.w()}, paint_of(ink), edge});
  return static_cast<std::uint32_t>(vertices_.size() - 1);
}

std::uint32_t DrawList::add_lit(const Vector3d& place, const Vector3d& normal, const Ink& ink,
                                const Ink& ground) {
  const Vector3d to_eye = camera_from_space_ * (eye_ - place).normalized();
  return add(clip(place), over(lit(ink, camera_from_space_ * normal, to_eye), ground), no_edge);
}

void DrawList::band(std::uint32_t first, std::uint32_t second, std::uint32_t count,
                    std::vector<std::uint32_t>& indices) {
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t next = (i + 1) % count;
    indices.insert(indices.end(),
                   {first + i, first + next, second + i, second + i, first + next, second + next});
  }
}

Vector2d DrawList::pixel(std::uint32_t vertex) const {
  const glm::vec4& c = vertices_[vertex].clip;
  return half_size_.cwiseProduct(Vector2d(c.x, c.y)) / c.w;
}

std::uint32_t DrawList::add_moved(std::uint32_t vertex, const Vector2d& pixels, float coverage) {
  Vertex moved = vertices_[vertex];
  moved.clip.x += static_cast<float>(pixels.x() / half_size_.x()) * moved.clip.w;
  moved.clip.y += static_cast<float>(pixels.y() / half_size_.y()) * moved.clip.w;
  constexpr float most = 8;  // coverage in the middle of an imaginary line with this side
  moved.edge = {most - coverage, 0, most - 0.5F};
  vertices_.push_back(moved);
  return static_cast<std::uint32_t>(vertices_.size() - 1);
}

void DrawList::add_edge_quad(std::uint32_t first, std::uint32_t second, const Vector4d& inside,
                             std::vector<std::uint32_t>& indices) {
  if (vertices_[first].clip.w <= 0 || vertices_[second].clip.w <= 0 || inside.w() <= 0) return;
  const Vector2d along = pixel(second) - pixel(first);
  Vector2d across = Vector2d(-along.y(), along.x()).stableNormalized();
  const Vector2d middle = half_size_.cwiseProduct(inside.head<2>()) / inside.w();
  if (across.dot(0.5 * (pixel(first) + pixel(second)) - middle) < 0) across = -across;
  const auto n = static_cast<std::uint32_t>(vertices_.size());
  for (const std::uint32_t end : {first, second}) {
    add_moved(end, -0.75 * across, 1.25F);  // slightly over the shrunk surface, which has facets
    add_moved(end, 0.5 * across, 0);
  }
  indices.insert(indices.end(), {n, n + 1, n + 2, n + 2, n + 1, n + 3});
}

void DrawList::disc(const Vector3d& centre, const Vector3d& normal, double radius,
                    const Ink& middle, const Ink& rim) {
  begin_thing();
  const Matrix3d frame = body::frame_with_z_along(normal);
  const std::uint32_t hub = add(clip(centre), middle, no_edge);
  for (std::uint32_t i = 0; i < around_disc; ++i) {
    const double angle = 2 * std::numbers::pi * i / around_disc;
    const Vector3d out = frame * Vector3d(std::cos(angle), std::sin(angle), 0);
    add(clip(centre + radius * out), rim, no_edge);
    items_.faces.insert(items_.faces.end(), {hub, hub + 1 + i, hub + 1 + (i + 1) % around_disc});
  }
}

void DrawList::cap(const Vector3d& middle, std::span<const Vector3d> rim,
                   const std::function<Ink(const Vector3d&)>& ink_at) {
  begin_thing();
  constexpr std::uint32_t rings = 16;
  const auto around = static_cast<std::uint32_t>(rim.size());
  const auto first = static_cast<std::uint32_t>(vertices_.size());
  for (std::uint32_t i = 0; i <= rings; ++i) {
    const double share = static_cast<double>(i) / rings;
    for (const Vector3d& end : rim) {
      const Vector3d point = ((1 - share) * middle + share * end).normalized();
      add(clip(point), ink_at(point), no_edge);
    }
    if (i > 0) band(first + i * around, first + (i - 1) * around, around, items_.faces);
  }
}

/// On the unit sphere the near side is a cap about the direction to the eye at distance d, up to
/// the angle whose cosine is 1 / d.
void DrawList::ellipsoid(const Matrix3d& space_from_unit, const Ink& ink, double rim,
                         const Ink& ground) {
  const Vector3d eye = space_from_unit.inverse() * eye_;
  if (!(eye.norm() > 1)) return;
  begin_thing();
  const Matrix3d frame = body::frame_with_z_along(eye);
  const Matrix3d normal_from_unit = space_from_unit.inverse().transpose();
  const double size = space_from_unit.norm() * pixels(Vector3d::Zero());
  const auto rings = static_cast<std::uint32_t>(std::clamp(1.1 * std::sqrt(size), 8.0, 32.0));
  const std::uint32_t around = 4 * rings;  // facets deviate from the silhouette by 0.15 pixels
  const auto first = static_cast<std::uint32_t>(vertices_.size());
  for (std::uint32_t i = 0; i <= rings; ++i) {
    const double from_pole = std::acos(1 / eye.norm()) * i / rings;
    for (std::uint32_t j = 0; j < around; ++j) {
      const double longitude = 2 * std::numbers::pi * j / around;
      const Vector3d unit =
          frame * Vector3d(std::sin(from_pole) * std::cos(longitude),
                           std::sin(from_pole) * std::sin(longitude), std::cos(from_pole));
      const Vector3d normal = (normal_from_unit * unit).normalized();
      const Vector3d place = space_from_unit * unit;
      const double facing = std::clamp(normal.dot((eye_ - place).normalized()), 0.0, 1.0);
      const double glass = std::pow(1 - facing, 3);
      add_lit(place, normal, {ink.color, ink.opacity + (rim - ink.opacity) * glass}, ground);
    }
    if (i > 0) band(first + i * around, first + (i - 1) * around, around, items_.faces);
  }
  soften_rim(first + rings * around, around);
}

/// Moves a closed ring of vertices about the origin inwards, to the inner side of the edge quads
/// that are added along its former position. Does nothing if a part of the ring is behind the eye,
/// where edge quads are impossible.
void DrawList::soften_rim(std::uint32_t first, std::uint32_t count) {
  const Vector4d inside = clip(Vector3d::Zero());
  const auto rim = std::span(vertices_).subspan(first, count);
  const auto is_behind = [](const Vertex& vertex) { return vertex.clip.w <= 0; };
  if (inside.w() <= 0 || std::ranges::any_of(rim, is_behind)) return;
  for (std::uint32_t i = 0; i < count; ++i) {
    add_edge_quad(first + i, first + (i + 1) % count, inside, items_.faces);
  }
  const auto edge_quads = first + count;
  for (std::uint32_t i = 0; i < count; ++i)
    vertices_[first + i].clip = vertices_[edge_quads + 4 * i].clip;
}

void DrawList::add_to(ScreenArea& area) const {
  auto next = things_.begin();
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    for (; next != things_.end() && *next == i; ++next) area.begin_shape();
    const glm::vec4& clip = vertices_[i].clip;
    area.add({clip.x, clip.y, clip.z, clip.w});
  }
}

}  // namespace twrench::picture
