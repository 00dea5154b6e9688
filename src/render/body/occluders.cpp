#include "render/body/occluders.h"

#include <algorithm>
#include <utility>

namespace twrench::render {
namespace {

using Eigen::Vector3d;

Vector3d half_sizes(const body::Cylinder& c) { return {c.radius, c.radius, c.length / 2}; }
Vector3d half_sizes(const body::Box& b) { return b.size / 2; }
Vector3d half_sizes(const body::Ellipsoid& e) { return e.radii; }
Vector3d half_sizes(const auto& shape) { return Vector3d::Constant(body::bounding_radius(shape)); }

/// Returns the point on the capsule's segment that is nearest to `point`.
Vector3d nearest_on_axis(const Capsule& capsule, const Vector3d& point) {
  const Vector3d along = capsule.to - capsule.from;
  const double squared = along.squaredNorm();
  if (squared == 0) return capsule.from;
  return capsule.from + std::clamp((point - capsule.from).dot(along) / squared, 0.0, 1.0) * along;
}

/// The gap between two capsules in cm, negative if they overlap: alternates between the nearest
/// points of their axes, which converges for convex sets (von Neumann's alternating projections).
double gap(const Capsule& a, const Capsule& b) {
  Vector3d on_a = (a.from + a.to) / 2;
  Vector3d on_b = b.from;
  constexpr int turns = 16;
  for (int i = 0; i < turns; ++i) {
    on_b = nearest_on_axis(b, on_a);
    on_a = nearest_on_axis(a, on_b);
  }
  return (on_a - on_b).norm() - a.radius - b.radius;
}

}  // namespace

Capsule capsule_of(const body::Part& part) {
  const Vector3d half = std::visit([](const auto& shape) { return half_sizes(shape); }, part.shape);
  Eigen::Index longest = 2;
  half.maxCoeff(&longest);
  const double radius = (half.sum() - half[longest]) / 2;
  const double half_length = std::max(0.0, half[longest] - radius / 2);
  const Vector3d along = half_length * part.body_from_part.col(longest);
  return {part.position - along, part.position + along, radius, false};
}

std::vector<std::vector<Capsule>> find_occluders(std::span<const body::Part> parts,
                                                 std::size_t most) {
  std::vector<Capsule> capsules;
  for (const body::Part& part : parts) capsules.push_back(capsule_of(part));
  std::vector<std::vector<Capsule>> result;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    std::vector<std::pair<double, std::size_t>> near;
    for (std::size_t j = 0; j < parts.size(); ++j) {
      if (j == i) continue;
      const double distance = gap(capsules[i], capsules[j]);
      if (distance < 2 * capsules[j].radius) near.emplace_back(distance, j);
    }
    std::ranges::sort(near);
    near.resize(std::min(near.size(), most));
    auto& found = result.emplace_back();
    for (const auto& [distance, j] : near) {
      found.push_back(capsules[j]);
      found.back().meets =
          distance < 0 && j < i && std::holds_alternative<body::Cylinder>(parts[j].shape);
    }
  }
  return result;
}

}  // namespace twrench::render
