// The lines and dots of a draw list, which face the eye.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "picture/overlay/draw_list.h"

namespace twrench::picture {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector4d;

}  // namespace

/// Returns whether the line may go straight from `last`, which it left along `heading`, past
/// `here`. It then deviates from the arc by a sagitta of length * angle / 8, and its colour hardly
/// changes.
bool DrawList::may_skip(const Projected& last, const Vector2d& heading, const Projected& here,
                        const Projected& next) {
  constexpr double least_step = 0.5, most_astray = 0.1, most_change = 0.08;  // px, px, opacity
  const Vector2d way = here.pixel - last.pixel, onward = next.pixel - here.pixel;
  if (way.norm() < least_step) return true;
  const double sine = heading.x() * onward.y() - heading.y() * onward.x();
  return heading.dot(onward) > 0 && way.norm() * std::abs(sine) < 8 * most_astray * onward.norm() &&
         std::abs(here.point->ink.opacity - last.point->ink.opacity) < most_change;
}

void DrawList::line(std::span<const Point> points) {
  begin_thing();
  add_line(points, items_.faces);
}

void DrawList::line_on_halo(std::span<const Point> points, const Color& halo) {
  std::vector<Point> around(points.begin(), points.end());
  for (Point& point : around) {
    point.width += 2 * halo_of(point.width);
    point.ink.color = halo;
  }
  line(around);
  line(points);
}

void DrawList::add_line(std::span<const Point> points, std::vector<std::uint32_t>& faces) {
  run_.clear();
  for (const Point& point : points) {
    const Vector4d c = clip(point.place);
    if (c.w() > 1e-6 * std::abs(c.z())) {
      run_.push_back({&point, c, half_size_.cwiseProduct(c.head<2>()) / c.w()});
    } else {
      add_run(faces);
    }
  }
  add_run(faces);
}

void DrawList::add_run(std::vector<std::uint32_t>& faces) {
  if (run_.empty()) return;
  const bool open = (run_.front().pixel - run_.back().pixel).norm() > 1 || run_.size() == 1;
  const Projected* last = nullptr;
  Vector2d heading(1, 0), across(0, 1);
  for (std::size_t i = 0; i < run_.size(); ++i) {
    const Projected& here = run_[i];
    const Projected& next = run_[std::min(i + 1, run_.size() - 1)];
    if (last != nullptr && i + 1 < run_.size() && may_skip(*last, heading, here, next)) continue;
    // The direction at a point is that from the previous to the next one.
    const Vector2d along = next.pixel - run_[i > 0 ? i - 1 : 0].pixel;
    const Vector2d before = across;
    if (along.norm() > 1e-3) across = Vector2d(-along.y(), along.x()).normalized();
    constexpr double sharp = 0.5;  // cosine of a turn at which two sides would cross
    if (last == nullptr) {
      if (open) add_end(here, across, -1);
    } else if (before.dot(across) < sharp) {
      add_end(*last, before, 1);
      join_sides(faces);
      add_sides(*last, across);
    }
    add_sides(here, across);
    if (open || last != nullptr) join_sides(faces);
    heading = (next.pixel - here.pixel).stableNormalized();
    last = &here;
  }
  if (open) {
    add_end(run_.back(), across, 1);
    join_sides(faces);
  }
  run_.clear();
}

/// Adds sides beyond the end of a line that make the end round. `forwards` is 1 at the last point
/// of the line and -1 at its first.
void DrawList::add_end(const Projected& here, const Vector2d& across, double forwards) {
  add_sides(here, across, forwards * Vector2d(across.y(), -across.x()));
}

/// Adds the two sides of a line at a point or, with a unit vector `beyond`, half the line's width
/// away from it in that direction.
void DrawList::add_sides(const Projected& here, const Vector2d& across, const Vector2d& beyond) {
  const double width = here.point->width, half = 0.5 * std::max(width, 1.0);
  const double reach = half + 1;  // the ramp's half pixel, and half a pixel of margin
  const Ink& ink = here.point->ink;
  for (const double side : {1.0, -1.0}) {
    const Vector2d away = reach * (side * across + beyond);
    Vector4d corner = here.clip;
    corner.head<2>() += (corner.w() * away).cwiseQuotient(half_size_);
    add(corner, {ink.color, ink.opacity * std::min(width, 1.0)},
        {static_cast<float>(side * reach), static_cast<float>(reach * beyond.norm()),
         static_cast<float>(half)});
  }
}

/// Joins the last two pairs of sides.
void DrawList::join_sides(std::vector<std::uint32_t>& faces) {
  const auto n = static_cast<std::uint32_t>(vertices_.size());
  faces.insert(faces.end(), {n - 4, n - 3, n - 2, n - 2, n - 3, n - 1});
}

void DrawList::dot(const Vector3d& place, double radius, const Ink& ink) {
  const Vector4d c = clip(place);
  if (!(c.w() > 1e-6 * std::abs(c.z()))) return;
  begin_thing();
  const double half_extent = radius + 1;
  const auto n = static_cast<std::uint32_t>(vertices_.size());
  for (const auto& [x, y] : {std::pair(-1, -1), {1, -1}, {-1, 1}, {1, 1}}) {
    Vector4d corner = c;
    corner.head<2>() += (half_extent * c.w() * Vector2d(x, y)).cwiseQuotient(half_size_);
    const auto r = static_cast<float>(half_extent);
    add(corner, ink,
        {r * static_cast<float>(x), r * static_cast<float>(y), static_cast<float>(radius)});
  }
  items_.faces.insert(items_.faces.end(), {n, n + 1, n + 2, n + 2, n + 1, n + 3});
}

}  // namespace twrench::picture
