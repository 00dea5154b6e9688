#include "picture/views/blur_sampling.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <unordered_set>

#include "picture/shapes/shapes.h"

namespace twrench::picture {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int cells = 16;  // per bounding radius, of a grid with one point in each cell

Vector3d place_of(const Mesh& mesh, std::uint32_t vertex) {
  const glm::vec3& place = mesh.vertices[vertex].position;
  return {place.x, place.y, place.z};
}

/// Returns the least thickness of a shape in cm; 0 if it may be thin anywhere.
double thickness(const body::Shape& shape) {
  const bool has_hollows = !traits_of(shape).occluder.has_value();
  return has_hollows ? 0 : body::bounding_box(shape).sizes().minCoeff();
}

double least_thickness(std::span<const body::Part> parts) {
  double least = std::numeric_limits<double>::infinity();
  for (const body::Part& part : parts) least = std::min(least, thickness(part.shape));
  return least;
}

/// A point of the surface, in pixels of the picture, in the first and in the last pose.
struct Streak {
  Vector2d from, to;

  double length() const { return (to - from).norm(); }

  /// Whether it comes within `reach` pixels of the area.
  bool touches(const image::Area& area, double reach) const {
    const Vector2d low = from.cwiseMin(to).array() - reach,
                   high = from.cwiseMax(to).array() + reach;
    return high.x() > area.x && low.x() < area.x + area.width && high.y() > area.y &&
           low.y() < area.y + area.height;
  }
};

}  // namespace

bool is_in_exposure(int i, int count, int total) {
  for (int k = 0; k < count; ++k) {
    // Rounded away from the middle, so that the chosen poses lie symmetrically about it.
    const double place = (k + 0.5) * total / count - 0.5;
    const bool is_late = place > 0.5 * (total - 1);
    if (i == (is_late ? std::floor(place + 0.5) : std::ceil(place - 0.5))) return true;
  }
  return false;
}

BlurSampling::BlurSampling(std::span<const body::Part> parts, const Mesh& mesh, double radius)
    : thickness_(least_thickness(parts)),
      radius_(radius),
      reach_(std::numbers::sqrt3 * radius / cells) {
  const double cell = radius / cells;
  std::unordered_set<std::int64_t> seen;
  const auto add = [&](const Vector3d& point) {
    std::int64_t key = 0;
    for (const double x : point) key = key * 4096 + std::lround(x / cell);
    if (seen.insert(key).second) points_.push_back(point);
  };
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const Vector3d a = place_of(mesh, mesh.indices[i]);
    const Vector3d ab = place_of(mesh, mesh.indices[i + 1]) - a;
    const Vector3d ac = place_of(mesh, mesh.indices[i + 2]) - a;
    const int steps = 1 + static_cast<int>(std::max(ab.norm(), ac.norm()) / cell);
    for (int j = 0; j <= steps; ++j) {
      for (int k = 0; k + j <= steps; ++k) add(a + (j * ab + k * ac) / steps);
    }
  }
}

std::vector<int> BlurSampling::counts(std::span<const image::Area> areas, const Camera& camera,
                                      const image::Area& pane,
                                      std::span<const Matrix3d> poses) const {
  const int total = static_cast<int>(poses.size());
  const double step =
      total > 1 ? Eigen::AngleAxisd(Matrix3d(poses[1] * poses[0].transpose())).angle() : 0;
  const double at_edge = 0.5 * step * (total - 1) * std::min(pane.width, pane.height);  // pixels
  const double apart = at_edge / total;
  const double scale = camera.projection(1, 1) * pane.height / (2 * camera.distance);  // px per cm
  // The path of a point through a larger angle is too curved to be described by its ends. Separate
  // poses of a thin part are visible unless they are close together.
  constexpr double largest_angle = 0.3;  // rad
  const double thin = std::max(4 * apart, 8.0);
  if (!(step * total < largest_angle) || thickness_ * scale < thin || camera.distance <= radius_) {
    return std::vector<int>(areas.size(), total);
  }
  std::vector<Streak> streaks;
  streaks.reserve(points_.size());
  for (const Vector3d& point : points_) {
    streaks.push_back({pixel_of(camera, pane, poses.front() * point),
                       pixel_of(camera, pane, poses.back() * point)});
  }
  std::vector<int> result;
  for (const image::Area& area : areas) {
    double farthest = -1;
    for (const Streak& streak : streaks) {
      if (streak.touches(area, reach_ * scale)) farthest = std::max(farthest, streak.length());
    }
    const double steps = std::min(farthest / std::max(apart, 1e-9), 1.0 * total);
    const int needed = std::max(static_cast<int>(std::ceil(steps)), 2);
    // An even number of poses has none in the middle.
    const int symmetric = total % 2 == 0 ? needed + needed % 2 : needed;
    result.push_back(farthest < 0 ? 1 : symmetric);
  }
  return result;
}

}  // namespace twrench::picture
