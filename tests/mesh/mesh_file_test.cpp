#include "mesh/mesh_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "mesh/samples.h"

namespace twrench::mesh {
namespace {

using testing::HasSubstr;

TEST(MeshFile, OfACubeInObjHasItsIntegrals) {
  const MeshFile file = read_mesh(cube_obj(), "cube.obj", {.scale = 0.1});
  EXPECT_NEAR(file.shape.integrals.volume, 1e-3, 1e-18);
  EXPECT_NEAR(file.area, 0.06, 1e-16);
  EXPECT_LE((file.shape.integrals.centroid - Eigen::Vector3d(0.05, 0.05, 0.05)).norm(), 1e-17);
  EXPECT_EQ(file.open_edges, 0U);
  EXPECT_EQ(file.components, 1U);
  EXPECT_EQ(file.shape.surface->triangles.size(), 12U);
}

TEST(MeshFile, OfACubeInBinaryStlIsTheSame) {
  const MeshFile file = read_mesh(binary_stl(cube({0, 0, 0}, 1)), "cube.stl", {.scale = 1.0});
  EXPECT_EQ(file.shape.integrals.volume, 1);
  EXPECT_EQ(file.shape.surface->vertices.size(), 8U);
}

TEST(MeshFile, WithoutAUnitIsRefused) {
  try {
    read_mesh(cube_obj(), "cube.obj", {});
    FAIL();
  } catch (const MeshError& error) {
    EXPECT_EQ(error.reason(), MeshError::Reason::no_scale);
  }
}

}  // namespace
}  // namespace twrench::mesh
