#include "picture/body/half_edges.h"

#include <utility>

namespace twrench::picture {
namespace {

/// A half-edge, stored at the lower-numbered of its ends.
struct HalfEdge {
  std::uint32_t other;  ///< The end with the higher number.
  std::uint32_t number;
  bool upwards;  ///< Whether it leads to the other end.
};

/// Half-edges by their lower end: those of corner i from begins[i] to begins[i + 1].
struct Buckets {
  std::vector<std::size_t> begins;
  std::vector<HalfEdge> half_edges;
};

Buckets by_lower_end(std::span<const std::uint32_t> corners, std::size_t count) {
  const auto ends = [&](std::uint32_t half_edge) {
    return std::pair(corners[half_edge], corners[next_half_edge(half_edge)]);
  };
  const auto size = static_cast<std::uint32_t>(corners.size());
  Buckets result{std::vector<std::size_t>(count + 1), std::vector<HalfEdge>(size)};
  for (std::uint32_t i = 0; i < size; ++i) {
    const auto [from, to] = ends(i);
    ++result.begins[std::min(from, to) + 1];
  }
  std::partial_sum(result.begins.begin(), result.begins.end(), result.begins.begin());
  std::vector<std::size_t> next(result.begins.begin(), result.begins.end() - 1);
  for (std::uint32_t i = 0; i < size; ++i) {
    const auto [from, to] = ends(i);
    result.half_edges[next[std::min(from, to)]++] = {std::max(from, to), i, from < to};
  }
  return result;
}

/// Pairs the half-edges between the same two corners. At any time, all unpaired ones have the same
/// direction.
void pair_up(std::span<const HalfEdge> half_edges, std::vector<std::uint32_t>& opposite) {
  std::vector<HalfEdge> waiting;
  std::size_t first = 0;
  for (const HalfEdge& half_edge : half_edges) {
    if (first == waiting.size() || waiting[first].upwards == half_edge.upwards) {
      waiting.push_back(half_edge);
      continue;
    }
    const std::uint32_t partner = waiting[first++].number;
    opposite[half_edge.number] = partner;
    opposite[partner] = half_edge.number;
  }
}

}  // namespace

std::vector<std::uint32_t> opposite_half_edges(std::span<const std::uint32_t> corners,
                                               std::size_t count) {
  auto [begins, half_edges] = by_lower_end(corners, count);
  std::vector<std::uint32_t> opposite(corners.size(), no_half_edge);
  for (std::size_t corner = 0; corner < count; ++corner) {
    const std::span bucket(half_edges.data() + begins[corner], begins[corner + 1] - begins[corner]);
    std::ranges::sort(bucket, {}, [](const HalfEdge& h) { return std::pair(h.other, h.number); });
    for (std::size_t begin = 0; begin < bucket.size();) {
      std::size_t end = begin;
      while (end < bucket.size() && bucket[end].other == bucket[begin].other) ++end;
      pair_up(bucket.subspan(begin, end - begin), opposite);
      begin = end;
    }
  }
  return opposite;
}

}  // namespace twrench::picture
