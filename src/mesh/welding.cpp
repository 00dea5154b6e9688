#include "mesh/welding.h"

#include <twrench/base/error.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

#include "mesh/allowance.h"
#include "mesh/disjoint_sets.h"

namespace twrench::mesh {
namespace {

using body::TriangleMesh;
using Eigen::Vector3d;

constexpr std::uint32_t empty_slot = std::numeric_limits<std::uint32_t>::max();

/// A hash table of the indices of points. At most half of its slots are used.
class PointTable {
 public:
  /// Returns the first index with this hash that `is_it` accepts, or `empty_slot`. `is_it` is also
  /// called for neighbours in the table with other hashes.
  template <typename Predicate>
  std::uint32_t find(std::uint64_t hash, Predicate is_it) const {
    for (std::size_t at = slot(hash); slots_[at] != empty_slot;
         at = (at + 1) & (slots_.size() - 1)) {
      if (is_it(slots_[at])) return slots_[at];
    }
    return empty_slot;
  }

  /// Adds an index; `hash_of` returns the hash of any index.
  template <typename Hash>
  void insert(std::uint32_t index, Hash hash_of) {
    if (2 * ++count_ > slots_.size()) grow(hash_of);
    place(index, hash_of(index));
  }

 private:
  // The upper bits of a product are the well-mixed ones.
  std::size_t slot(std::uint64_t hash) const { return hash >> (64U - bits_); }

  void place(std::uint32_t index, std::uint64_t hash) {
    std::size_t at = slot(hash);
    while (slots_[at] != empty_slot) at = (at + 1) & (slots_.size() - 1);
    slots_[at] = index;
  }

  template <typename Hash>
  void grow(Hash hash_of) {
    const std::vector<std::uint32_t> old = std::move(slots_);
    slots_.assign(std::size_t{1} << ++bits_, empty_slot);
    for (const std::uint32_t index : old) {
      if (index != empty_slot) place(index, hash_of(index));
    }
  }

  unsigned bits_ = 10;
  std::size_t count_ = 0;
  std::vector<std::uint32_t> slots_ =
      std::vector<std::uint32_t>(std::size_t{1} << bits_, empty_slot);
};

std::uint64_t hash_of(const Vector3d& point) {
  std::uint64_t hash = 0;
  for (const double coordinate : point) {
    const auto bits = std::bit_cast<std::uint64_t>(coordinate + 0.0);  // -0 is 0
    hash = (std::rotl(hash, 29) ^ bits ^ (bits >> 32U)) * 0x9E3779B97F4A7C15U;
  }
  return hash;
}

/// Joins coincident vertices, and keeps only those that triangles refer to, in the order of first
/// use.
void join_equal(TriangleMesh& mesh) {
  PointTable table;
  TriangleMesh joined;
  std::vector<std::uint32_t> index_of(mesh.vertices.size(), empty_slot);
  const auto hash = [&](std::uint32_t index) { return hash_of(joined.vertices[index]); };
  const auto index_for = [&](std::uint32_t old) {
    const Vector3d& point = mesh.vertices[old];
    const std::uint32_t found = table.find(
        hash_of(point), [&](std::uint32_t index) { return joined.vertices[index] == point; });
    if (found != empty_slot) return found;
    const auto added = static_cast<std::uint32_t>(joined.vertices.size());
    joined.vertices.push_back(point);
    if (!mesh.colors.empty()) joined.colors.push_back(mesh.colors[old]);
    table.insert(added, hash);
    return added;
  };
  for (auto& triangle : mesh.triangles) {
    for (std::uint32_t& corner : triangle) {
      std::uint32_t& index = index_of[corner];
      if (index == empty_slot) index = index_for(corner);
      corner = index;
    }
  }
  mesh.vertices = std::move(joined.vertices);
  mesh.colors = std::move(joined.colors);
}

/// Returns sets of vertices that are connected by distances within the tolerance. Only vertices in
/// adjacent cells of a grid can be that close. Throws InvalidArgument if too many are.
DisjointSets near_ones(const TriangleMesh& mesh, double tolerance) {
  const auto cell = [&](const Vector3d& point) -> Vector3d {
    return (point / tolerance).array().floor();
  };
  PointTable table;
  DisjointSets sets(mesh.vertices.size());
  Allowance allowance(usual_steps);
  for (std::uint32_t i = 0; i < mesh.vertices.size(); ++i) {
    const Vector3d& point = mesh.vertices[i];
    for (int n = 0; n < 27; ++n) {
      const Vector3d neighbour = cell(point) + Vector3d(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
      std::size_t compared = 0;
      table.find(hash_of(neighbour), [&](std::uint32_t other) {
        ++compared;
        if ((mesh.vertices[other] - point).norm() <= tolerance) sets.join(i, other);
        return false;
      });
      allowance.take(compared);
    }
    if (allowance.is_used_up()) {
      throw InvalidArgument("weld", "too many vertices are within the tolerance of each other",
                            "take a smaller one");
    }
    table.insert(i, [&](std::uint32_t index) { return hash_of(cell(mesh.vertices[index])); });
  }
  return sets;
}

/// Joins each set at its first vertex. Returns the number of vertices removed.
std::size_t join(TriangleMesh& mesh, DisjointSets&& sets) {
  std::size_t joined = 0;
  for (std::uint32_t i = 0; i < mesh.vertices.size(); ++i) {
    const std::uint32_t first = sets.find(i);
    if (first == i) continue;
    ++joined;
    mesh.vertices[i] = mesh.vertices[first];
  }
  if (joined > 0) join_equal(mesh);
  return joined;
}

}  // namespace

Welded weld(TriangleMesh& mesh, double tolerance) {
  join_equal(mesh);
  Welded result;
  // Vertices that are closer than their own rounding coincide.
  double greatest = 0.0;
  for (const Vector3d& vertex : mesh.vertices) {
    greatest = std::max(greatest, vertex.cwiseAbs().maxCoeff());
  }
  if (tolerance > 1e-16 * greatest) {
    result.joined_vertices = join(mesh, near_ones(mesh, tolerance));
  }
  result.removed_triangles = std::erase_if(
      mesh.triangles, [](const auto& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  return result;
}

}  // namespace twrench::mesh
