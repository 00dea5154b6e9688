#include "picture/space/screen_area.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <ranges>
#include <utility>

namespace twrench::picture {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Spans closer than this are merged: the pixels between them cost less than another rectangle.
constexpr double least_gap = 32;

/// Columns from low to high; empty if reversed.
struct ColumnSpan {
  double low = infinity, high = -infinity;

  void add(const ColumnSpan& other) {
    low = std::min(low, other.low);
    high = std::max(high, other.high);
  }
};

/// The extent of the segment from `a` to `b` between the heights `top` and `bottom`.
ColumnSpan span_between(const Eigen::Array2d& a, const Eigen::Array2d& b, double top,
                        double bottom) {
  if (std::max(a.y(), b.y()) < top || std::min(a.y(), b.y()) > bottom) return {};
  const auto at = [&](const Eigen::Array2d& end) {
    const double y = std::clamp(end.y(), top, bottom);
    return y == end.y() ? end.x() : a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
  };
  const auto [low, high] = std::minmax({at(a), at(b)});
  return {low, high};
}

/// The point that is outermost in a direction.
Eigen::Array2d outermost(const std::vector<Eigen::Array2d>& points, const Eigen::Array2d& out) {
  std::size_t best = 0;
  double farthest = -infinity;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double distance = (out * points[i]).sum();
    if (distance > farthest) best = i, farthest = distance;
  }
  return points[best];
}

/// Removes points inside the polygon of those that are outermost in some directions (Akl and
/// Toussaint, "A Fast Convex Hull Algorithm", 1978). If there are many points, this removes nearly
/// all.
std::vector<Eigen::Array2d> outer_points(const std::vector<Eigen::Array2d>& points) {
  constexpr int directions = 16;
  if (points.size() < std::size_t{4} * directions) return points;
  std::vector<Eigen::Array2d> polygon;
  for (int i = 0; i < directions; ++i) {
    const double angle = 2 * std::numbers::pi * i / directions;
    const Eigen::Array2d point = outermost(points, {std::cos(angle), std::sin(angle)});
    if (polygon.empty() || (point != polygon.back()).any()) polygon.push_back(point);
  }
  const auto is_outside = [&](const Eigen::Array2d& point) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Eigen::Array2d edge = polygon[(i + 1) % polygon.size()] - polygon[i];
      const Eigen::Array2d way = point - polygon[i];
      if (edge.x() * way.y() < edge.y() * way.x()) return true;
    }
    return false;
  };
  std::vector<Eigen::Array2d> result = polygon;
  std::ranges::copy_if(points, std::back_inserter(result), is_outside);
  return result;
}

/// The corners of the convex hull of `points` in order; the first and the last point are repeated
/// (Andrew, "Another Efficient Algorithm for Convex Hulls in Two Dimensions", 1979). Boost's takes
/// long to compile.
std::vector<Eigen::Array2d> hull(const std::vector<Eigen::Array2d>& points) {
  std::vector<Eigen::Array2d> sorted = outer_points(points);
  std::ranges::sort(sorted, {}, [](const Eigen::Array2d& p) { return std::pair(p.x(), p.y()); });
  std::vector<Eigen::Array2d> result;
  // Adds the half of the hull from the first to the last point, which turns one way only.
  const auto add_half = [&result](const auto& half) {
    const std::size_t start = result.size();
    for (const Eigen::Array2d& point : half) {
      const auto last_turns_back = [&] {
        const Eigen::Array2d edge = result.back() - result[result.size() - 2];
        const Eigen::Array2d next = point - result.back();
        return edge.x() * next.y() >= edge.y() * next.x();
      };
      while (result.size() >= start + 2 && last_turns_back()) result.pop_back();
      result.push_back(point);
    }
  };
  add_half(sorted);
  add_half(sorted | std::views::reverse);
  return result;
}

/// Merges spans that overlap or are close, from left to right.
std::vector<ColumnSpan> merged(std::vector<ColumnSpan> spans) {
  std::ranges::sort(spans, {}, &ColumnSpan::low);
  std::vector<ColumnSpan> result;
  for (const ColumnSpan& span : spans) {
    if (result.empty() || span.low > result.back().high + least_gap) {
      result.push_back(span);
    } else {
      result.back().add(span);
    }
  }
  return result;
}

}  // namespace

void ScreenArea::add(const Eigen::Vector4f& clip) {
  if (!(clip.w() > 0) || !clip.allFinite()) {
    all_ = true;
    return;
  }
  const Eigen::Vector4d c = clip.cast<double>();
  const Pixel size(pane_.width, pane_.height);
  const Pixel place(c.x() / c.w(), -c.y() / c.w());
  shapes_.back().points.emplace_back(Pixel(pane_.x, pane_.y) + (0.5 + 0.5 * place) * size);
}

/// Returns the pixels of the pane between two points, at least one.
image::Area ScreenArea::pixels_between(const Pixel& low, const Pixel& high) const {
  // Compared as doubles first: a point just in front of the eye's plane may be out of an int's
  // range.
  const auto first = [](double place, int start, int size) {
    return static_cast<int>(std::floor(std::clamp(place, 1.0 * start, start + size - 1.0)));
  };
  const auto end = [](double place, int start, int size) {
    return static_cast<int>(std::ceil(std::clamp(place, start + 1.0, 1.0 * start + size)));
  };
  const int x = first(low.x(), pane_.x, pane_.width);
  const int y = first(low.y(), pane_.y, pane_.height);
  return {x, y, std::max(1, end(high.x(), pane_.x, pane_.width) - x),
          std::max(1, end(high.y(), pane_.y, pane_.height) - y)};
}

image::Area ScreenArea::bounds() const {
  if (all_) return pane_;
  Pixel low(infinity, infinity), high(-infinity, -infinity);
  for (const auto& [points, margin] : shapes_) {
    for (const Pixel& point : points) {
      low = low.min(point - margin);
      high = high.max(point + margin);
    }
  }
  return pixels_between(low, high);
}

std::vector<image::Area> ScreenArea::bands(int height) const {
  if (all_) return {pane_};
  const int first = pane_.y / height;
  const int count = (pane_.y + pane_.height - 1) / height - first + 1;
  std::vector<std::vector<ColumnSpan>> spans(static_cast<std::size_t>(count));
  for (const auto& [points, margin] : shapes_) {
    const auto corners = hull(points);
    if (corners.empty()) continue;
    const auto [low, high] =
        std::ranges::minmax_element(corners, {}, [](const Eigen::Array2d& p) { return p.y(); });
    const auto band_of = [&](double y) {
      return static_cast<int>(std::clamp(std::floor(y / height) - first, 0.0, count - 1.0));
    };
    for (int band = band_of(low->y() - margin); band <= band_of(high->y() + margin); ++band) {
      const double top = (first + band) * height - margin;
      ColumnSpan span;
      for (std::size_t i = 1; i < corners.size(); ++i) {
        span.add(span_between(corners[i - 1], corners[i], top, top + height + 2 * margin));
      }
      if (span.low > span.high) continue;
      spans[static_cast<std::size_t>(band)].push_back({span.low - margin, span.high + margin});
    }
  }
  std::vector<image::Area> areas;
  for (int band = 0; band < count; ++band) {
    const double top = (first + band) * height;
    for (const ColumnSpan& span : merged(std::move(spans[static_cast<std::size_t>(band)]))) {
      if (span.high < pane_.x || span.low > pane_.x + pane_.width) continue;
      areas.push_back(pixels_between({span.low, top}, {span.high, top + height}));
    }
  }
  return areas;
}

}  // namespace twrench::picture
