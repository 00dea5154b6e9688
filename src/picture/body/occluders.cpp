#include "picture/body/occluders.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "picture/body/lumps.h"

namespace twrench::picture {
namespace {

using Eigen::Vector3d;

/// Half the sizes of a box that has about the shape's volume.
Vector3d half_sizes(const body::Shape& shape) {
  const Vector3d half = body::bounding_box(shape).sizes() / 2;
  const auto* const cone = std::get_if<body::Cone>(&shape);
  if (cone == nullptr) return half;
  const double radius = (cone->radius + cone->top_radius) / 2;
  return {radius, radius, half.z()};
}

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

/// The smallest gap between one of several capsules and another.
double gap(const std::vector<Capsule>& some, const Capsule& other) {
  double least = std::numeric_limits<double>::infinity();
  for (const Capsule& each : some) least = std::min(least, gap(each, other));
  return least;
}

/// Whether the seam where another part enters it can be found in the shader.
bool has_round_side(const body::Shape& shape) {
  return std::holds_alternative<body::Cylinder>(shape) ||
         std::holds_alternative<body::Capsule>(shape);
}

}  // namespace

Capsule capsule_of(const body::Part& part) {
  const Vector3d half = half_sizes(part.shape);
  const Vector3d centre =
      part.position + part.body_from_part * body::bounding_box(part.shape).center();
  Eigen::Index longest = 2;
  half.maxCoeff(&longest);
  const double radius = (half.sum() - half[longest]) / 2;
  const double half_length = std::max(0.0, half[longest] - radius / 2);
  const Vector3d along = half_length * part.body_from_part.col(longest);
  return {centre - along, centre + along, radius};
}

std::vector<Capsule> capsules_of(const body::Part& part) {
  if (const auto* const capsule = std::get_if<body::Capsule>(&part.shape)) {
    const Vector3d along = capsule->length / 2 * part.body_from_part.col(2);
    return {{part.position - along, part.position + along, capsule->radius}};
  }
  const bool is_lumpy = std::holds_alternative<body::Torus>(part.shape) ||
                        std::holds_alternative<body::Tube>(part.shape) ||
                        std::holds_alternative<body::Mesh>(part.shape);
  return is_lumpy ? lumps(part) : std::vector{capsule_of(part)};
}

std::vector<std::vector<Capsule>> find_occluders(std::span<const body::Part> parts,
                                                 std::size_t most) {
  std::vector<std::vector<Capsule>> capsules;
  for (const body::Part& part : parts) capsules.push_back(capsules_of(part));
  std::vector<std::vector<Capsule>> result;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    std::vector<std::pair<double, Capsule>> near;
    for (std::size_t j = 0; j < parts.size(); ++j) {
      if (j == i) continue;
      for (Capsule other : capsules[j]) {
        const double distance = gap(capsules[i], other);
        if (distance >= 2 * other.radius) continue;
        other.meets = distance < 0 && j < i && has_round_side(parts[j].shape);
        other.part = j;
        near.emplace_back(distance, other);
      }
    }
    std::ranges::stable_sort(near, {}, &std::pair<double, Capsule>::first);
    near.resize(std::min(near.size(), most));
    auto& found = result.emplace_back();
    for (const auto& [distance, capsule] : near) found.push_back(capsule);
  }
  return result;
}

}  // namespace twrench::picture
