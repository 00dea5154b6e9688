#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace twrench::mesh {

/// Disjoint sets of the numbers from 0, which can be joined (union-find).
class DisjointSets {
 public:
  /// Starts with one set per number.
  explicit DisjointSets(std::size_t count) : parents_(count) {
    std::iota(parents_.begin(), parents_.end(), 0U);
  }

  std::size_t size() const { return parents_.size(); }

  /// Returns the least number of the set that contains `number`.
  std::uint32_t find(std::uint32_t number) {
    while (parents_[number] != number) {
      parents_[number] = parents_[parents_[number]];
      number = parents_[number];
    }
    return number;
  }

  /// Joins the sets that contain `a` and `b`.
  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a), b = find(b);
    if (b < a) std::swap(a, b);
    parents_[b] = a;
  }

 private:
  std::vector<std::uint32_t> parents_;
};

}  // namespace twrench::mesh
