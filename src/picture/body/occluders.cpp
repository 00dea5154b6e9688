#include "picture/body/occluders.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "picture/body/lumps.h"
#include "picture/shapes/shapes.h"

namespace twrench::picture {
namespace {

using Eigen::Vector3d;

/// Returns the point on the capsule's segment that is nearest to `point`.
Vector3d nearest_on_axis(const Capsule& capsule, const Vector3d& point) {
  const Vector3d along = capsule.to - capsule.from;
  const double squared = along.squaredNorm();
  if (squared == 0) return capsule.from;
  return capsule.from + std::clamp((point - capsule.from).dot(along) / squared, 0.0, 1.0) * along;
}

/// Whether a shape is a plate: a capsule of its volume sticks out of it.
bool is_plate(const body::Shape& shape) {
  constexpr double least_ratio = 3;  // of the middle size to the smallest one
  Vector3d sizes = body::bounding_box(shape).sizes();
  std::ranges::sort(sizes);
  return sizes[1] > least_ratio * sizes[0];
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

/// Whether most of a capsule lies inside a part with these capsules, where it shades nothing.
bool enclose(const std::vector<Capsule>& some, const Capsule& other) {
  constexpr double least_depth = 0.1;  // of an end of its axis, in its radii
  return std::ranges::all_of(std::array{other.from, other.to}, [&](const Vector3d& end) {
    return std::ranges::any_of(some, [&](const Capsule& each) {
      const double depth = each.radius - (nearest_on_axis(each, end) - end).norm();
      return !each.is_of_plate && depth >= least_depth * other.radius;
    });
  });
}

}  // namespace

std::vector<Capsule> capsules_of(const body::Part& part) {
  const std::optional<AxisCapsule> own = traits_of(part.shape).occluder;
  if (!own) return lumps(part);
  const Vector3d along = own->half_length * part.body_from_part.col(own->axis);
  return {{.from = part.position - along,
           .to = part.position + along,
           .radius = own->radius,
           .is_of_plate = is_plate(part.shape)}};
}

std::vector<std::vector<Capsule>> find_occluders(std::span<const body::Part> parts,
                                                 std::size_t most) {
  std::vector<std::vector<Capsule>> capsules;
  std::vector<bool> have_round_side, is_foil;
  for (const body::Part& part : parts) {
    capsules.push_back(capsules_of(part));
    const ShapeTraits traits = traits_of(part.shape);
    have_round_side.push_back(traits.has_round_side);
    is_foil.push_back(traits.is_foil);
  }
  std::vector<std::vector<Capsule>> result;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    std::vector<std::pair<double, Capsule>> near;
    for (std::size_t j = 0; j < parts.size(); ++j) {
      if (j == i || is_foil[i] || is_foil[j]) continue;
      for (Capsule other : capsules[j]) {
        if (other.is_of_plate || enclose(capsules[i], other)) continue;
        const double distance = gap(capsules[i], other);
        if (distance >= 2 * other.radius) continue;
        other.meets = distance < 0 && j < i && have_round_side[j];
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
