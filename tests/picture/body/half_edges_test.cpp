#include "picture/body/half_edges.h"

#include <gtest/gtest.h>

#include <array>

namespace twrench::picture {
namespace {

TEST(HalfEdges, OfAClosedSurfaceAreAllPaired) {
  const std::vector<std::uint32_t> tetrahedron{0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
  const auto opposite = opposite_half_edges(tetrahedron, 4);
  for (std::uint32_t i = 0; i < opposite.size(); ++i) {
    ASSERT_NE(opposite[i], no_half_edge);
    EXPECT_EQ(opposite[opposite[i]], i);
    EXPECT_EQ(tetrahedron[i], tetrahedron[next_half_edge(opposite[i])]);
    EXPECT_EQ(tetrahedron[next_half_edge(i)], tetrahedron[opposite[i]]);
  }
}

TEST(HalfEdges, AtABorderHaveNoPartner) {
  const auto opposite = opposite_half_edges(std::vector<std::uint32_t>{0, 1, 2, 2, 1, 3}, 4);
  EXPECT_EQ(opposite, (std::vector<std::uint32_t>{no_half_edge, 3, no_half_edge, 1, no_half_edge,
                                                  no_half_edge}));
}

// Two closed surfaces that share one edge, and the same triangle twice.
TEST(HalfEdges, OfManyTrianglesAtOneEdgeArePairedInTurn) {
  const auto fan =
      opposite_half_edges(std::vector<std::uint32_t>{0, 1, 2, 1, 0, 3, 0, 1, 4, 1, 0, 5}, 6);
  EXPECT_EQ(fan[0], 3U);
  EXPECT_EQ(fan[6], 9U);
  const auto twice = opposite_half_edges(std::vector<std::uint32_t>{0, 1, 2, 0, 1, 2, 1, 0, 3}, 4);
  EXPECT_EQ(twice[0], 6U);
  EXPECT_EQ(twice[3], no_half_edge);
}

TEST(FirstEqual, IsTheFirstInItsPlace) {
  constexpr std::array values{3, 1, 3, 2, 1, 3};
  const auto first = first_equal(
      values.size(), [&](std::uint32_t i, std::uint32_t j) { return values[i] < values[j]; });
  EXPECT_EQ(first, (std::vector<std::uint32_t>{0, 1, 0, 3, 1, 0}));
}

}  // namespace
}  // namespace twrench::picture
