#include "picture/body/half_turn.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <variant>
#include <vector>

#include "body/moments.h"
#include "picture/body/bounding_radius.h"

namespace twrench::picture {
namespace {

using body::PrincipalAxes;
using Eigen::Vector3d;
using SrgbColor = std::array<float, 3>;

constexpr double imperceptible = 1e-3;  // distance in bounding radii, see the header

Vector3d half_turned(const Vector3d& v, const Vector3d& axis) { return 2 * axis.dot(v) * axis - v; }

std::vector<Vector3d> vertices_of(const body::Mesh& mesh, const body::Part& part) {
  std::vector<Vector3d> vertices;
  for (const Vector3d& vertex : mesh.surface->vertices) {
    vertices.emplace_back(part.position + part.body_from_part * vertex);
  }
  return vertices;
}

/// The vertices of a mesh in body axes, sorted into cells, so that those near a place are found
/// quickly.
class VertexCells {
 public:
  /// Finds vertices within `reach` cm. The distance of all places from the origin must be less than
  /// a million times that.
  VertexCells(const body::Mesh& mesh, const body::Part& part, double reach)
      : vertices_(vertices_of(mesh, part)), colors_(&mesh.surface->colors), reach_(reach) {
    for (std::uint32_t i = 0; i < vertices_.size(); ++i) cells_.emplace_back(cell(vertices_[i]), i);
    std::ranges::sort(cells_);
  }

  /// Whether each vertex has a counterpart of its colour in `other` after half a turn.
  bool become(const VertexCells& other, const Vector3d& axis) const {
    if (colors_->empty() != other.colors_->empty()) return false;
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      const SrgbColor* color = colors_->empty() ? nullptr : &(*colors_)[i];
      if (!other.contain(half_turned(vertices_[i], axis), color)) return false;
    }
    return true;
  }

  /// Returns the vertices that are farthest from the origin; none if these are many.
  std::vector<Vector3d> farthest() const {
    constexpr std::size_t most = 64;
    double farthest = 0;
    for (const Vector3d& vertex : vertices_) farthest = std::max(farthest, vertex.norm());
    std::vector<Vector3d> found;
    for (const Vector3d& vertex : vertices_) {
      if (vertex.norm() > farthest - reach_) found.push_back(vertex);
      if (found.size() > most) return {};
    }
    return found;
  }

 private:
  using Cell = std::uint64_t;

  Cell cell(const Vector3d& place) const {
    Cell result = 0;
    for (const double x : place) {
      const double index = std::floor(x / (2 * reach_)) + (1 << 20);
      result = result << 21U | static_cast<Cell>(index);
    }
    return result;
  }

  bool contain(const Vector3d& place, const SrgbColor* color) const {
    for (unsigned corner = 0; corner < 8; ++corner) {
      const Vector3d signs((corner & 1U) != 0 ? 1 : -1, (corner & 2U) != 0 ? 1 : -1,
                           (corner & 4U) != 0 ? 1 : -1);
      const Cell near = cell(place + reach_ * signs);
      for (auto at = std::ranges::lower_bound(cells_, std::pair(near, std::uint32_t{0}));
           at != cells_.end() && at->first == near; ++at) {
        const std::size_t i = at->second;
        if ((vertices_[i] - place).norm() > reach_) continue;
        if (color == nullptr || are_alike(*color, (*colors_)[i])) return true;
      }
    }
    return false;
  }

  static bool are_alike(const SrgbColor& a, const SrgbColor& b) {
    constexpr float just_noticeable = 0.02F;
    return std::ranges::equal(a, b,
                              [](float x, float y) { return std::abs(x - y) <= just_noticeable; });
  }

  std::vector<Vector3d> vertices_;
  const std::vector<SrgbColor>* colors_;
  double reach_;
  std::vector<std::pair<Cell, std::uint32_t>> cells_;  ///< The cell of each vertex, sorted.
};

/// Unit vectors in all directions, without symmetry: a spiral of equal areas.
std::vector<Vector3d> directions_without_symmetry() {
  constexpr int count = 40;
  std::vector<Vector3d> directions;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count;
    const double angle = i * 2 * std::numbers::pi / (std::numbers::phi * std::numbers::phi);
    const double across = std::sqrt(1 - z * z);
    directions.emplace_back(across * std::cos(angle), across * std::sin(angle), z);
  }
  return directions;
}

/// A body as it is seen.
class SeenBody {
 public:
  SeenBody(std::span<const body::Part> parts, std::span<const std::size_t> looks)
      : parts_(parts), looks_(looks), reach_(imperceptible * bounding_radius(parts)) {
    for (const body::Part& part : parts) {
      const auto* const mesh = std::get_if<body::Mesh>(&part.shape);
      cells_.push_back(mesh == nullptr ? std::nullopt
                                       : std::optional(VertexCells(*mesh, part, reach_)));
    }
  }

  bool is_same_after(const Vector3d& axis) const {
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      bool has_counterpart = false;
      for (std::size_t j = 0; j < parts_.size() && !has_counterpart; ++j) {
        has_counterpart = becomes(i, j, axis);
      }
      if (!has_counterpart) return false;
    }
    return true;
  }

  /// Returns the axes about which half a turn may map the body to itself: it maps the first part
  /// to some part, and thus a direction u of the first to a direction v or -v of that one, which
  /// takes an axis along u + v or u - v. This is not complete: an axis of a mesh that has many
  /// farthest vertices is found only if it is an axis of its file.
  std::vector<Vector3d> possible_axes() const {
    std::vector<Vector3d> axes;
    const auto add = [&](const Vector3d& axis) {
      if (axis.norm() > imperceptible) axes.push_back(axis.normalized());
    };
    const std::vector<Vector3d> own = directions(0);
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      for (const Vector3d& v : directions(i)) {
        add(v);
        for (const Vector3d& u : own) {
          add(u + v);
          add(u - v);
        }
      }
    }
    return axes;
  }

 private:
  /// Whether half a turn maps part i to part j.
  bool becomes(std::size_t i, std::size_t j, const Vector3d& axis) const {
    if (looks_[i] != looks_[j] || parts_[i].shape.index() != parts_[j].shape.index()) return false;
    if (cells_[i]) {
      return cells_[i]->become(*cells_[j], axis) && cells_[j]->become(*cells_[i], axis);
    }
    // Two shapes of one kind that extend equally far in all directions are equal, except for the
    // bore of a tube.
    const double a = body::volume(parts_[i].shape), b = body::volume(parts_[j].shape);
    if (std::abs(a - b) > imperceptible * std::max(a, b)) return false;
    static const std::vector<Vector3d> directions = directions_without_symmetry();
    return std::ranges::all_of(directions, [&](const Vector3d& direction) {
      const double turned = extent_along(parts_[i], half_turned(direction, axis));
      return std::abs(turned - extent_along(parts_[j], direction)) <= reach_;
    });
  }

  /// Unit vectors that turn with a part.
  std::vector<Vector3d> directions(std::size_t part) const {
    const auto& [shape, density, position, body_from_part] = parts_[part];
    std::vector<Vector3d> found;
    for (Eigen::Index i = 0; i < 3; ++i) found.emplace_back(body_from_part.col(i));
    if (position.norm() > reach_) found.push_back(position.normalized());
    if (!cells_[part]) return found;
    for (const Vector3d& vertex : cells_[part]->farthest()) found.push_back(vertex.normalized());
    return found;
  }

  std::span<const body::Part> parts_;
  std::span<const std::size_t> looks_;
  double reach_;
  std::vector<std::optional<VertexCells>> cells_;  ///< One for each part that is a mesh.
};

}  // namespace

std::optional<Vector3d> reversed_axis(const PrincipalAxes& principal) {
  const auto& [moments, axes] = principal;
  const bool lower = body::are_equal_moments(moments[0], moments[1]);
  const bool upper = body::are_equal_moments(moments[1], moments[2]);
  if (lower && upper) return std::nullopt;
  if (lower) return axes.col(PrincipalAxes::greatest);
  return axes.col(upper ? PrincipalAxes::least : PrincipalAxes::intermediate);
}

bool looks_the_same_after_half_turn(std::span<const body::Part> parts,
                                    std::span<const std::size_t> looks, const Vector3d& axis) {
  return SeenBody(parts, looks).is_same_after(axis);
}

bool looks_the_same_turned_over(std::span<const body::Part> parts,
                                std::span<const std::size_t> looks,
                                const PrincipalAxes& principal) {
  const SeenBody body(parts, looks);
  const std::optional<Vector3d> reversed = reversed_axis(principal);
  std::vector<Vector3d> axes;
  // A body whose moments differ can be symmetric only about its principal axes.
  if (!reversed || *reversed != principal.axes.col(PrincipalAxes::intermediate)) {
    axes = body.possible_axes();
  }
  for (const Eigen::Index i : {0, 1, 2}) axes.emplace_back(principal.axes.col(i));
  return std::ranges::any_of(axes, [&](const Vector3d& axis) {
    const bool reverses = !reversed || std::abs(axis.dot(*reversed)) < imperceptible;
    return reverses && body.is_same_after(axis);
  });
}

}  // namespace twrench::picture
