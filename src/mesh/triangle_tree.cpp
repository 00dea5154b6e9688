#include "mesh/triangle_tree.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <utility>

#include "base/parallel.h"

namespace twrench::mesh {
namespace {

using Eigen::AlignedBox3f;
using Eigen::Vector3f;

constexpr std::size_t leaf_size = 4;

/// Spreads the lower ten bits of a number, so that there are two zeros between neighbours.
std::uint32_t spread_bits(std::uint32_t x) {
  x = (x | x << 16U) & 0x030000FFU;
  x = (x | x << 8U) & 0x0300F00FU;
  x = (x | x << 4U) & 0x030C30C3U;
  return (x | x << 2U) & 0x09249249U;
}

/// Returns the position of a point on Morton's curve through the box (G. M. Morton, 1966).
std::uint32_t place_on_curve(const AlignedBox3f& box, const Vector3f& point) {
  constexpr float least = std::numeric_limits<float>::min();
  const Vector3f scaled = 1023.0F * (point - box.min()).cwiseQuotient(box.sizes().cwiseMax(least));
  const auto bits = [&](Eigen::Index i) {
    return spread_bits(static_cast<std::uint32_t>(std::clamp(scaled[i], 0.0F, 1023.0F)));
  };
  return bits(0) | bits(1) << 1U | bits(2) << 2U;
}

struct Keyed {
  std::uint32_t key, index;
};

/// Sorts stably by 30-bit keys.
void sort_by_key(std::vector<Keyed>& items) {
  std::vector<Keyed> other(items.size());
  constexpr std::uint32_t digit = 1024;
  for (std::uint32_t shift = 0; shift < 30; shift += 10) {
    std::array<std::size_t, digit + 1> end{};
    for (const Keyed& item : items) ++end[(item.key >> shift) % digit + 1];
    for (std::size_t i = 1; i < end.size(); ++i) end[i] += end[i - 1];
    for (const Keyed& item : items) other[end[(item.key >> shift) % digit]++] = item;
    std::swap(items, other);
  }
}

}  // namespace

TriangleTree::TriangleTree(const body::TriangleMesh& mesh) : mesh_(&mesh) {
  for (const Eigen::Vector3d& vertex : mesh.vertices) whole_.extend(vertex);
  const AlignedBox3f all(Vector3f::Zero(), whole_.sizes().cast<float>());
  const std::size_t count = mesh.triangles.size();
  constexpr std::size_t grain = 1 << 15;
  std::vector<Keyed> places(count);
  for_each_part(count, grain, 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto index = static_cast<std::uint32_t>(i);
      places[i] = {place_on_curve(all, rounded_box(index).center()), index};
    }
  });
  sort_by_key(places);
  items_.resize(count);
  first_leaf_ = std::bit_ceil((count + leaf_size - 1) / leaf_size);
  boxes_.resize(2 * first_leaf_);
  for_each_part(first_leaf_, grain / leaf_size, 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t leaf = begin; leaf < end; ++leaf) {
      for (std::size_t i = leaf * leaf_size; i < std::min((leaf + 1) * leaf_size, count); ++i) {
        items_[i] = {rounded_box(places[i].index), places[i].index};
        boxes_[first_leaf_ + leaf].extend(items_[i].box);
      }
    }
  });
  for (std::size_t node = first_leaf_ - 1; node > 0; --node) {
    boxes_[node] = boxes_[2 * node].merged(boxes_[2 * node + 1]);
  }
}

AlignedBox3f TriangleTree::rounded_box(std::uint32_t triangle) const {
  AlignedBox3f box;
  for (std::size_t k = 0; k < 3; ++k) {
    box.extend((corner(triangle, k) - whole_.min()).cast<float>());
  }
  return box;
}

std::span<const TriangleTree::Item> TriangleTree::items(std::size_t leaf) const {
  const std::size_t begin = std::min((leaf - first_leaf_) * leaf_size, items_.size());
  return std::span(items_).subspan(begin, std::min(leaf_size, items_.size() - begin));
}

}  // namespace twrench::mesh
