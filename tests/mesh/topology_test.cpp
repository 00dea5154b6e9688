#include "mesh/topology.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/samples.h"

namespace twrench::mesh {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

TEST(Topology, OfClosedSurfacesIsBalanced) {
  const Topology found = topology(joined(cube({0, 0, 0}, 1), cube({5, 0, 0}, 1)));
  EXPECT_THAT(found.open, IsEmpty());
  EXPECT_THAT(found.opposed, IsEmpty());
  EXPECT_THAT(found.branching, IsEmpty());
  EXPECT_EQ(found.unbalanced, 0U);
  EXPECT_EQ(found.components, 2U);
  EXPECT_EQ(found.component[11], 0U);
  EXPECT_EQ(found.component[12], 1U);
}

TEST(Topology, ClassifiesEdges) {
  body::TriangleMesh mesh = cube({0, 0, 0}, 1);
  mesh.triangles.erase(mesh.triangles.begin());  // from vertex 0 to 3 to 2
  const Topology open = topology(mesh);
  EXPECT_THAT(open.open, ElementsAre(DirectedEdge{0, 2}, DirectedEdge{3, 0}, DirectedEdge{2, 3}));
  EXPECT_EQ(open.unbalanced, 3U);
  mesh = cube({0, 0, 0}, 1);
  std::swap(mesh.triangles[0][0], mesh.triangles[0][1]);
  const Topology opposed = topology(mesh);
  EXPECT_THAT(opposed.opposed, SizeIs(3));
  EXPECT_EQ(opposed.unbalanced, 3U);
  mesh.triangles.push_back({0, 3, 2});
  const Topology branching = topology(mesh);
  EXPECT_THAT(branching.branching, SizeIs(3));
  EXPECT_THAT(branching.opposed, IsEmpty());
}

}  // namespace
}  // namespace twrench::mesh
