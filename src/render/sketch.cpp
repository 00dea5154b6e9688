#include "render/sketch.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "body/shape.h"

namespace twrench {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector4d;

constexpr double head_length = 5.5, head_radius = 2.4;  // of an arrow, in radii of its shaft
constexpr std::uint32_t around_arrow = 28;
constexpr std::uint32_t around_disc = 96;

const glm::vec3 everywhere(0, 0, 1e6F);  // the edge of what has none: not a line

glm::vec4 paint_of(const Ink& ink) {
  const double scale = ink.opacity / 255;
  const Vector4d p(scale * ink.color.red, scale * ink.color.green, scale * ink.color.blue,
                   ink.opacity);
  const Eigen::Vector4f f = p.cast<float>();
  return {f.x(), f.y(), f.z(), f.w()};
}

/// A light from above the camera's right shoulder, a weaker one from its left, and a gleam; a
/// gloss that is plain beside the body's metal. All vectors of length 1, in camera axes.
Ink lit(const Ink& ink, const Vector3d& normal, const Vector3d& to_eye) {
  static const Vector3d key = Vector3d(0.45, 0.75, 0.5).normalized();
  static const Vector3d fill = Vector3d(-0.8, 0.1, 0.6).normalized();
  const double light =
      0.52 + 0.45 * std::max(normal.dot(key), 0.0) + 0.18 * std::max(normal.dot(fill), 0.0);
  const double gleam = 0.35 * std::pow(std::max(normal.dot((key + to_eye).normalized()), 0.0), 40);
  const auto channel = [&](int value) {
    const double base = std::min(light * value, 255.0);
    return static_cast<int>(std::lround(base + gleam * (255 - base)));
  };
  return {{channel(ink.color.red), channel(ink.color.green), channel(ink.color.blue)}, ink.opacity};
}

}  // namespace

void Sketch::begin(const Camera& camera, const Area& pane) {
  clip_from_space_ = camera.projection * camera.view;
  camera_from_space_ = camera.camera_from_space();
  eye_ = -camera_from_space_.transpose() * camera.view.col(3).head<3>();
  half_size_ = 0.5 * Vector2d(pane.width, pane.height);
  scale_ = camera.projection(1, 1) * half_size_.y();
  vertices_.clear();
  indices_.clear();
}

Vector4d Sketch::clip(const Vector3d& place) const {
  return clip_from_space_ * place.homogeneous();
}

double Sketch::pixels(const Vector3d& place) const {
  const double depth = clip_from_space_.row(3) * place.homogeneous();
  return depth > 0 ? scale_ / depth : 0;
}

std::uint32_t Sketch::add(const Vector4d& clip, const Ink& ink, const glm::vec3& edge) {
  const Eigen::Vector4f c = clip.cast<float>();
  vertices_.push_back({{c.x(), c.y(), c.z(), c.w()}, paint_of(ink), edge});
  return static_cast<std::uint32_t>(vertices_.size() - 1);
}

std::uint32_t Sketch::add_lit(const Vector3d& place, const Vector3d& normal, const Ink& ink) {
  const Vector3d to_eye = camera_from_space_ * (eye_ - place).normalized();
  return add(clip(place), lit(ink, camera_from_space_ * normal, to_eye), everywhere);
}

void Sketch::band(std::uint32_t first, std::uint32_t second, std::uint32_t count) {
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t next = (i + 1) % count;
    indices_.insert(indices_.end(),
                    {first + i, first + next, second + i, second + i, first + next, second + next});
  }
}

/// Whether the line may go straight from `last`, which it left along `heading`, past `here`: it
/// strays from the arc by a sagitta of length * angle / 8, and what it is drawn in hardly changes.
bool Sketch::may_skip(const Projected& last, const Vector2d& heading, const Projected& here,
                      const Projected& next) {
  constexpr double least_step = 0.5, most_astray = 0.1, most_change = 0.08;  // px, px, opacity
  const Vector2d way = here.pixel - last.pixel, onward = next.pixel - here.pixel;
  if (way.norm() < least_step) return true;
  const double sine = heading.x() * onward.y() - heading.y() * onward.x();
  return heading.dot(onward) > 0 && way.norm() * std::abs(sine) < 8 * most_astray * onward.norm() &&
         std::abs(here.point->ink.opacity - last.point->ink.opacity) < most_change;
}

void Sketch::line(std::span<const Point> points) {
  run_.clear();
  for (const Point& point : points) {
    const Vector4d c = clip(point.place);
    if (c.w() > 1e-6 * std::abs(c.z())) {
      run_.push_back({&point, c, half_size_.cwiseProduct(c.head<2>()) / c.w()});
    } else {
      add_run();
    }
  }
  add_run();
}

void Sketch::add_run() {
  const Projected* last = nullptr;
  Vector2d heading(1, 0), across(0, 1);
  for (std::size_t i = 0; i < run_.size(); ++i) {
    const Projected& here = run_[i];
    const Projected& next = run_[std::min(i + 1, run_.size() - 1)];
    if (last != nullptr && i + 1 < run_.size() && may_skip(*last, heading, here, next)) continue;
    // The direction at a point is that from the one before to the one after.
    const Vector2d along = next.pixel - run_[i > 0 ? i - 1 : 0].pixel;
    if (along.norm() > 1e-3) across = Vector2d(-along.y(), along.x()).normalized();
    add_ends(here, across);
    if (last != nullptr) {
      const auto n = static_cast<std::uint32_t>(vertices_.size());
      indices_.insert(indices_.end(), {n - 4, n - 3, n - 2, n - 2, n - 3, n - 1});
    }
    heading = (next.pixel - here.pixel).stableNormalized();
    last = &here;
  }
  run_.clear();
}

/// The two sides of a line at a point.
void Sketch::add_ends(const Projected& here, const Vector2d& across) {
  const double width = here.point->width, half = 0.5 * std::max(width, 1.0);
  const Ink& ink = here.point->ink;
  for (const double side : {1.0, -1.0}) {
    const double reach = side * (half + 1);  // the ramp's half pixel, and one half to be safe
    Vector4d corner = here.clip;
    corner.head<2>() += (reach * corner.w() * across).cwiseQuotient(half_size_);
    add(corner, {ink.color, ink.opacity * std::min(width, 1.0)},
        {static_cast<float>(reach), 0, static_cast<float>(half)});
  }
}

void Sketch::dot(const Vector3d& place, double radius, const Ink& ink) {
  const Vector4d c = clip(place);
  if (!(c.w() > 1e-6 * std::abs(c.z()))) return;
  const double reach = radius + 1;
  const auto n = static_cast<std::uint32_t>(vertices_.size());
  for (const auto& [x, y] : {std::pair(-1, -1), {1, -1}, {-1, 1}, {1, 1}}) {
    Vector4d corner = c;
    corner.head<2>() += (reach * c.w() * Vector2d(x, y)).cwiseQuotient(half_size_);
    const auto r = static_cast<float>(reach);
    add(corner, ink,
        {r * static_cast<float>(x), r * static_cast<float>(y), static_cast<float>(radius)});
  }
  indices_.insert(indices_.end(), {n, n + 1, n + 2, n + 2, n + 1, n + 3});
}

void Sketch::cone(const Matrix3d& frame, const Vector3d& from, double length, const Vector2d& radii,
                  const Ink& ink) {
  const auto first = static_cast<std::uint32_t>(vertices_.size());
  for (const int end : {0, 1}) {
    for (std::uint32_t i = 0; i < around_arrow; ++i) {
      const double angle = 2 * std::numbers::pi * i / around_arrow;
      const Vector3d out(std::cos(angle), std::sin(angle), 0);
      const Vector3d normal = Vector3d(length * out.x(), length * out.y(), radii[0] - radii[1]);
      add_lit(from + frame * (radii[end] * out + end * length * Vector3d::UnitZ()),
              frame * normal.normalized(), ink);
    }
  }
  band(first, first + around_arrow, around_arrow);
}

void Sketch::arrow(const Vector3d& from, const Vector3d& to, double radius, const Ink& ink) {
  const double length = (to - from).norm();
  if (!(length > 0)) return;
  const double scale = std::min(1.0, length / (head_length * radius));
  const double head = head_length * radius * scale, shaft = length - head;
  const double wide = head_radius * radius * scale;
  const Matrix3d frame = frame_with_z_along(to - from);
  const Vector3d neck = from + shaft * frame.col(2);
  if (shaft > 0) cone(frame, from, shaft, {radius, radius}, ink);
  cone(frame, neck, head, {wide, 0}, ink);
  const std::uint32_t middle = add_lit(neck, -frame.col(2), ink);
  for (std::uint32_t i = 0; i < around_arrow; ++i) {
    const double angle = 2 * std::numbers::pi * i / around_arrow;
    add_lit(neck + wide * (frame * Vector3d(std::cos(angle), std::sin(angle), 0)), -frame.col(2),
            ink);
    indices_.insert(indices_.end(), {middle, middle + 1 + i, middle + 1 + (i + 1) % around_arrow});
  }
}

void Sketch::disc(const Vector3d& centre, const Vector3d& normal, double radius, const Ink& middle,
                  const Ink& rim) {
  const Matrix3d frame = frame_with_z_along(normal);
  const std::uint32_t hub = add(clip(centre), middle, everywhere);
  for (std::uint32_t i = 0; i < around_disc; ++i) {
    const double angle = 2 * std::numbers::pi * i / around_disc;
    const Vector3d out = frame * Vector3d(std::cos(angle), std::sin(angle), 0);
    add(clip(centre + radius * out), rim, everywhere);
    indices_.insert(indices_.end(), {hub, hub + 1 + i, hub + 1 + (i + 1) % around_disc});
  }
}

void Sketch::ellipsoid(const Matrix3d& space_from_unit, const Ink& ink, double rim) {
  const Matrix3d normal_from_unit = space_from_unit.inverse().transpose();
  const double size = space_from_unit.norm() * pixels(Vector3d::Zero());
  const auto parallels = static_cast<std::uint32_t>(std::clamp(2.2 * std::sqrt(size), 16.0, 64.0));
  const std::uint32_t meridians = 2 * parallels;  // facets stray from the outline by 0.15 pixels
  const auto first = static_cast<std::uint32_t>(vertices_.size());
  std::vector<Vector3d> places;
  for (std::uint32_t i = 0; i <= parallels; ++i) {
    const double latitude = std::numbers::pi * (static_cast<double>(i) / parallels - 0.5);
    for (std::uint32_t j = 0; j < meridians; ++j) {
      const double longitude = 2 * std::numbers::pi * j / meridians;
      const Vector3d unit(std::cos(latitude) * std::cos(longitude),
                          std::cos(latitude) * std::sin(longitude), std::sin(latitude));
      const Vector3d normal = (normal_from_unit * unit).normalized();
      places.push_back(space_from_unit * unit);
      const double facing = std::clamp(normal.dot((eye_ - places.back()).normalized()), 0.0, 1.0);
      const double glass = std::pow(1 - facing, 3);
      add_lit(places.back(), normal, {ink.color, ink.opacity + (rim - ink.opacity) * glass});
    }
  }
  const auto near_side = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const Vector3d normal = (places[b] - places[a]).cross(places[c] - places[a]);
    if (normal.dot(eye_ - places[a]) <= 0) return;
    indices_.insert(indices_.end(), {first + a, first + b, first + c});
  };
  for (std::uint32_t i = 0; i < parallels; ++i) {
    for (std::uint32_t j = 0; j < meridians; ++j) {
      const std::uint32_t a = i * meridians + j, b = i * meridians + (j + 1) % meridians;
      near_side(a, b, a + meridians);
      near_side(a + meridians, b, b + meridians);
    }
  }
}

void Sketch::add_to(ScreenArea& area) const {
  for (const Vertex& vertex : vertices_) {
    area.add({vertex.clip.x, vertex.clip.y, vertex.clip.z, vertex.clip.w});
  }
}

}  // namespace twrench
