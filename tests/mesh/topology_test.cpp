#include "mesh/topology.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/samples.h"
#include "mesh/welding.h"

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

/// Returns the topology after equal vertices have been joined.
Topology of_two(const body::TriangleMesh& one, const body::TriangleMesh& other) {
  body::TriangleMesh both = joined(one, other);
  weld(both, 0.0);
  return topology(both);
}

TEST(Topology, OfSolidsThatTouchIsClosed) {
  const body::TriangleMesh first = cube({0, 0, 0}, 1);
  for (const Eigen::Vector3d& place :
       {Eigen::Vector3d(1, 1, 0), Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(1, 1, 1)}) {
    const body::TriangleMesh second = cube(place, 1);
    EXPECT_TRUE(of_two(first, second).is_closed()) << place.transpose();
    EXPECT_TRUE(of_two(turned(first), turned(second)).is_closed()) << "both are inside out";
  }
  EXPECT_EQ(of_two(first, cube({1, 1, 0}, 1)).components, 1U) << "they share an edge";
  EXPECT_EQ(of_two(first, cube({1, 1, 1}, 1)).components, 2U);
}

TEST(Topology, OfSolidsThatOverlapAtAnEdgeIsNot) {
  const body::TriangleMesh first = cube({0, 0, 0}, 1);
  EXPECT_THAT(of_two(first, turned(cube({1, 1, 0}, 1))).overlapping, SizeIs(1));
  EXPECT_THAT(of_two(first, first).overlapping, SizeIs(18));
  EXPECT_FALSE(of_two(first, first).is_closed());
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
