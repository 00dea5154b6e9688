#include "picture/body/decimation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>
#include <span>

namespace twrench::picture {
namespace {

constexpr float normal_tolerance = 0.02F;  // rad
constexpr float color_tolerance = 0.02F;   // of linear light

using Corners = std::array<std::uint32_t, 3>;

/// How far the surface deviates from the given one near a vertex.
struct Deviation {
  float distance = 0, normal = 0, color = 0;  ///< cm, rad, linear light

  Deviation operator+(const Deviation& other) const {
    return {distance + other.distance, normal + other.normal, color + other.color};
  }
  void raise_to(const Deviation& other) {
    distance = std::max(distance, other.distance);
    normal = std::max(normal, other.normal);
    color = std::max(color, other.color);
  }
};

/// A point's projection on the plane of a triangle.
struct Projection {
  glm::vec3 shares;  ///< Barycentric coordinates; all positive inside.
  float distance;    ///< From the plane, unsigned.
};

Projection projected(const glm::vec3& point, const glm::vec3& a, const glm::vec3& b,
                     const glm::vec3& c) {
  const glm::vec3 normal = glm::cross(b - a, c - a);
  const float square = glm::dot(normal, normal);
  const float of_b = glm::dot(glm::cross(point - a, c - a), normal) / square;
  const float of_c = glm::dot(glm::cross(b - a, point - a), normal) / square;
  return {{1 - of_b - of_c, of_b, of_c}, std::abs(glm::dot(point - a, normal)) / std::sqrt(square)};
}

class Decimator {
 public:
  Decimator(Mesh& mesh, float tolerance)
      : mesh_(mesh), tolerance_(tolerance), deviations_(mesh.vertices.size()) {
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
      triangles_.push_back({mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]});
    }
  }

  void run() {
    constexpr int most_turns = 16;
    constexpr std::size_t least_share = 32;  // a turn that removes less than 1 / 32 is the last
    for (int turn = 0; turn < most_turns; ++turn) {
      const std::size_t before = triangles_.size();
      take_turn();
      if ((before - triangles_.size()) * least_share < before) break;
    }
    finish();
  }

 private:
  struct Collapse {
    std::uint32_t target;
    Deviation deviation;
    float cost;
  };

  /// Removes vertices of which no two are adjacent.
  void take_turn();
  void collect_fans();
  std::span<const std::uint32_t> fan(std::uint32_t vertex) const {
    return {fans_.data() + fan_begins_[vertex], fan_begins_[vertex + 1] - fan_begins_[vertex]};
  }
  bool collect_neighbours(std::uint32_t vertex);
  std::optional<Collapse> best_collapse(std::uint32_t vertex);
  std::optional<Collapse> collapse(std::uint32_t vertex, std::uint32_t target) const;
  bool keeps_topology(std::uint32_t vertex, std::uint32_t target);
  void apply(std::uint32_t vertex, const Collapse& collapse);
  void finish();
  const glm::vec3& place(std::uint32_t vertex) const { return mesh_.vertices[vertex].position; }
  Deviation deviation_at(std::uint32_t vertex, const Corners& corners,
                         const Projection& projection) const;

  Mesh& mesh_;
  float tolerance_;
  std::vector<Deviation> deviations_;  ///< For each vertex.
  std::vector<Corners> triangles_;
  std::vector<std::uint32_t> fans_;  ///< Triangles around each vertex, vertex by vertex.
  std::vector<std::uint32_t> fan_begins_;
  std::vector<char> is_touched_;  ///< Whether triangles of a vertex have changed in this turn.
  std::vector<std::uint32_t> neighbours_;  ///< Neighbours of the vertex that may be removed.
  std::vector<std::uint32_t> others_;      ///< Neighbours of one of these.
};

void Decimator::collect_fans() {
  fan_begins_.assign(mesh_.vertices.size() + 1, 0);
  for (const Corners& corners : triangles_) {
    for (const std::uint32_t corner : corners) ++fan_begins_[corner + 1];
  }
  for (std::size_t i = 1; i < fan_begins_.size(); ++i) fan_begins_[i] += fan_begins_[i - 1];
  std::vector<std::uint32_t> next(fan_begins_.begin(), fan_begins_.end() - 1);
  fans_.resize(3 * triangles_.size());
  for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
    for (const std::uint32_t corner : triangles_[i]) fans_[next[corner]++] = i;
  }
}

/// Returns whether triangles surround the vertex; each neighbour must be in two of them.
bool Decimator::collect_neighbours(std::uint32_t vertex) {
  constexpr std::size_t most = 16;  // beyond, collapsing is slow and makes slivers
  neighbours_.clear();
  if (fan(vertex).size() < 3 || fan(vertex).size() > most) return false;
  for (const std::uint32_t triangle : fan(vertex)) {
    for (const std::uint32_t corner : triangles_[triangle]) {
      if (corner != vertex) neighbours_.push_back(corner);
    }
  }
  std::ranges::sort(neighbours_);
  for (std::size_t i = 0; i < neighbours_.size(); i += 2) {
    const bool is_third = i + 2 < neighbours_.size() && neighbours_[i + 2] == neighbours_[i];
    if (neighbours_[i] != neighbours_[i + 1] || is_third) return false;
    neighbours_[i / 2] = neighbours_[i];
  }
  neighbours_.resize(neighbours_.size() / 2);
  return true;
}

void Decimator::take_turn() {
  collect_fans();
  is_touched_.assign(mesh_.vertices.size(), 0);
  for (std::uint32_t vertex = 0; vertex < mesh_.vertices.size(); ++vertex) {
    if (is_touched_[vertex] != 0 || !collect_neighbours(vertex)) continue;
    if (const auto best = best_collapse(vertex)) apply(vertex, *best);
  }
  std::erase_if(triangles_, [](const Corners& corners) { return corners[0] == corners[1]; });
}

/// Returns the cheapest collapse into one of the nearest neighbours.
std::optional<Decimator::Collapse> Decimator::best_collapse(std::uint32_t vertex) {
  std::ranges::sort(neighbours_, {}, [&](std::uint32_t i) {
    return glm::dot(place(i) - place(vertex), place(i) - place(vertex));
  });
  constexpr std::size_t most = 4;
  std::optional<Collapse> best;
  for (std::size_t i = 0; i < std::min(most, neighbours_.size()); ++i) {
    if (is_touched_[neighbours_[i]] != 0) continue;
    const auto found = collapse(vertex, neighbours_[i]);
    if (found && (!best || found->cost < best->cost)) best = found;
  }
  return best && keeps_topology(vertex, best->target) ? best : std::nullopt;
}

/// Returns whether the only common neighbours of the two vertices are those in their two common
/// triangles.
bool Decimator::keeps_topology(std::uint32_t vertex, std::uint32_t target) {
  others_.clear();
  for (const std::uint32_t triangle : fan(target)) {
    others_.insert(others_.end(), triangles_[triangle].begin(), triangles_[triangle].end());
  }
  std::ranges::sort(others_);
  others_.erase(std::unique(others_.begin(), others_.end()), others_.end());
  return std::ranges::count_if(neighbours_, [&](std::uint32_t neighbour) {
           return neighbour != target && neighbour != vertex &&
                  std::ranges::binary_search(others_, neighbour);
         }) == 2;
}

Deviation Decimator::deviation_at(std::uint32_t vertex, const Corners& corners,
                                  const Projection& projection) const {
  glm::vec3 normal(0), color(0);
  for (int k = 0; k < 3; ++k) {
    const std::uint32_t corner = corners[static_cast<std::size_t>(k)];
    normal += projection.shares[k] * mesh_.vertices[corner].normal;
    if (!mesh_.colors.empty()) color += projection.shares[k] * mesh_.colors[corner];
  }
  const float turn = glm::distance(glm::normalize(normal), mesh_.vertices[vertex].normal);
  const float tint = mesh_.colors.empty() ? 0 : glm::distance(color, mesh_.colors[vertex]);
  return {projection.distance, turn, tint};
}

/// Returns the effect of moving `vertex` into `target`; nothing if the surface would fold, have
/// slivers, or deviate too far.
std::optional<Decimator::Collapse> Decimator::collapse(std::uint32_t vertex,
                                                       std::uint32_t target) const {
  constexpr float least_cosine = 0.8F, least_width = 0.06F, beside = -0.02F;
  const Deviation before = deviations_[vertex];
  std::optional<Deviation> least;
  for (const std::uint32_t triangle : fan(vertex)) {
    Corners corners = triangles_[triangle];
    if (std::ranges::find(corners, target) != corners.end()) continue;
    const glm::vec3 old =
        glm::cross(place(corners[1]) - place(corners[0]), place(corners[2]) - place(corners[0]));
    std::ranges::replace(corners, vertex, target);
    const glm::vec3 &a = place(corners[0]), &b = place(corners[1]), &c = place(corners[2]);
    const glm::vec3 normal = glm::cross(b - a, c - a);
    const float size = glm::length(normal);
    const float longest =
        std::max({glm::dot(b - a, b - a), glm::dot(c - b, c - b), glm::dot(a - c, a - c)});
    if (!(size > least_width * longest)) return std::nullopt;
    if (glm::dot(normal, old) < least_cosine * size * glm::length(old)) return std::nullopt;
    const Projection projection = projected(place(vertex), a, b, c);
    if (glm::min(projection.shares.x, glm::min(projection.shares.y, projection.shares.z)) < beside)
      continue;
    const Deviation here = deviation_at(vertex, corners, projection);
    if (!least || here.distance < least->distance) least = here;
  }
  if (!least) return std::nullopt;
  const Deviation sum = before + *least;
  const float cost = std::max(
      {sum.distance / tolerance_, sum.normal / normal_tolerance, sum.color / color_tolerance});
  if (!(cost <= 1)) return std::nullopt;
  return Collapse{target, sum, cost};
}

/// Triangles that vanish get equal corners.
void Decimator::apply(std::uint32_t vertex, const Collapse& collapse) {
  for (const std::uint32_t triangle : fan(vertex)) {
    Corners& corners = triangles_[triangle];
    if (std::ranges::find(corners, collapse.target) != corners.end()) {
      corners = {};
    } else {
      std::ranges::replace(corners, vertex, collapse.target);
    }
  }
  is_touched_[vertex] = 1;
  for (const std::uint32_t neighbour : neighbours_) {
    is_touched_[neighbour] = 1;
    deviations_[neighbour].raise_to(collapse.deviation);
  }
}

/// Writes the remaining triangles and the vertices that they use.
void Decimator::finish() {
  constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> number(mesh_.vertices.size(), unused);
  std::vector<Vertex> vertices;
  std::vector<glm::vec3> colors;
  mesh_.indices.clear();
  for (const Corners& corners : triangles_) {
    for (const std::uint32_t corner : corners) {
      if (number[corner] == unused) {
        number[corner] = static_cast<std::uint32_t>(vertices.size());
        vertices.push_back(mesh_.vertices[corner]);
        if (!mesh_.colors.empty()) colors.push_back(mesh_.colors[corner]);
      }
      mesh_.indices.push_back(number[corner]);
    }
  }
  mesh_.vertices = std::move(vertices);
  mesh_.colors = std::move(colors);
}

}  // namespace

void decimate(Mesh& mesh, double tolerance) {
  // The removed vertices do not lie above one another: on a sphere the sum of their deviations is
  // three times the actual deviation.
  constexpr double overestimate = 3;
  if (tolerance > 0) Decimator(mesh, static_cast<float>(overestimate * tolerance)).run();
}

}  // namespace twrench::picture
