#include "mesh/mesh_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "mesh/refusal.h"
#include "mesh/samples.h"
#include "scratch_folder.h"
#include "system/file.h"

namespace twrench::mesh {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;
using testing::StartsWith;

TEST(MeshFile, HasItsIntegralsInCentimetres) {
  const MeshFile file = read_mesh(cube_obj(), "cube.obj", {.scale = 0.1});
  EXPECT_NEAR(file.shape.integrals.volume, 1e-3, 1e-18);
  EXPECT_NEAR(file.area, 0.06, 1e-16);
  EXPECT_LE((file.shape.integrals.centroid - Vector3d(0.05, 0.05, 0.05)).norm(), 1e-17);
  EXPECT_NEAR(file.shape.integrals.inertia(0, 0), 1e-5 / 6, 1e-20);
  EXPECT_EQ(file.open_edges, 0U);
  EXPECT_EQ(file.components, 1U);
  EXPECT_EQ(file.shape.surface->triangles.size(), 12U);
}

// Scaling rounds each coordinate. Far from the origin, this would be a millionth of a millionth of
// the body.
TEST(MeshFile, IsAsExactInAnyUnitAndFarAway) {
  const body::TriangleMesh far = moved(ball_with_open_poles(24, 12, 0), {12345.678, -9e3, 3e4});
  const MeshFile in_cm = read_mesh(obj_of(far), "a.obj", {.scale = 1.0}),
                 in_mm = read_mesh(obj_of(far), "a.obj", {.scale = 0.1});
  EXPECT_NEAR(in_mm.shape.integrals.volume * 1e3 / in_cm.shape.integrals.volume, 1, 1e-15);
  EXPECT_LE((in_mm.shape.integrals.inertia * 1e5 - in_cm.shape.integrals.inertia).norm(),
            2e-15 * in_cm.shape.integrals.inertia.norm());
}

TEST(MeshFile, IsKnownByItsNameInAnyCase) {
  for (const char* name : {"a.obj", "b/c.STL", "d.Ply", "e.gltf", "f.GLB", "g.dae", "h.3mf"}) {
    EXPECT_TRUE(is_mesh_name(name)) << name;
  }
  for (const char* name : {"a.toml", "obj", "a.obj.txt", "dzhanibekov", ""}) {
    EXPECT_FALSE(is_mesh_name(name)) << name;
  }
}

TEST(MeshFile, OfAnotherKindIsRefused) {
  EXPECT_THAT(refusal(cube_obj(), "a.3ds"), StartsWith("2 a.3ds: its extension is not"));
  EXPECT_EQ(refusal("", "a.stl"), "5 cannot read a.stl: it is empty");
}

TEST(MeshFile, ThatIsAnotherFileWithAWrongNameIsNamed) {
  using namespace std::string_literals;
  for (const auto& [bytes, kind] : {std::pair("\xFF\xD8\xFF\xE0\0\x10JFIF\0"s, "a JPEG picture"),
                                    {"\xEF\xBB\xBF<!DOCTYPE html>"s, "an HTML page"},
                                    {"ISO-10303-21;\nHEADER;\n"s, "a STEP model"},
                                    {"\x1F\x8B\x08\0\0\0\0\0"s, "compressed by gzip"},
                                    {"\xFF\xFEv\0 \0000\0"s, "text in UTF-16, not in UTF-8"},
                                    {"v\0 \0000\0 \0000\0"s, "text in UTF-16, not in UTF-8"},
                                    {"\xEF\xBB\xBF"s, "empty"},
                                    {""s, "empty"}}) {
    for (const char* ending : {"obj", "stl", "ply", "gltf", "glb"}) {
      const std::string name = "a."s + ending;
      EXPECT_EQ(refusal(bytes, name), fmt::format("5 cannot read {}: it is {}", name, kind));
    }
  }
}

TEST(MeshFile, NeedsAUnit) {
  for (const std::string& name : {std::string("cube.obj"), std::string("cube.stl")}) {
    try {
      read_mesh(name == "cube.obj" ? cube_obj() : binary_stl(cube({0, 0, 0}, 1)), name, {});
      FAIL();
    } catch (const MeshError& error) {
      EXPECT_EQ(error.reason(), MeshError::Reason::no_scale);
      EXPECT_THAT(error.remedy(), HasSubstr("unit = \"mm\""));
    }
  }
}

TEST(MeshFile, RefusesOptionsThatCannotBe) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {-1.0, std::nan(""), infinity}) {
    EXPECT_THAT(refusal(cube_obj(), "a.obj", {.scale = bad}), StartsWith("2 scale: "));
    EXPECT_THAT(refusal(cube_obj(), "a.obj", {.scale = 1.0, .weld = bad}), StartsWith("2 weld: "));
    EXPECT_THAT(refusal(cube_obj(), "a.obj", {.scale = 1.0, .shell = bad}),
                StartsWith("2 shell: "));
  }
  EXPECT_THAT(refusal(cube_obj(), "a.obj", {.scale = 1e100}),
              HasSubstr("its inertia in g cm^2 exceeds"));
  EXPECT_THAT(refusal(cube_obj(), "a.obj", {.scale = 1e-100}),
              HasSubstr("its inertia in g cm^2 exceeds"));
  EXPECT_EQ(refusal(cube_obj(), "a.obj", {.scale = 2.0, .weld = 0.04}),
            "2 weld: is 0.04 cm, but may be at most 0.0346, a hundredth of the size of the mesh");
  EXPECT_EQ(refusal(cube_obj(), "a.obj", {.scale = 1.0, .weld = 5e-324}), "nothing");
}

TEST(MeshFile, KnowsItsUnits) {
  EXPECT_EQ(unit_length("unit", "inch"), 2.54);
  EXPECT_EQ(unit_length("unit", "km"), 1e5);
  EXPECT_THROW(unit_length("unit", "ft"), InvalidArgument);
}

TEST(MeshFile, HasTheDigestOfItsBytes) {
  // As sha256sum prints it.
  EXPECT_EQ(read_mesh(cube_obj(), "a.obj", {.scale = 1.0}).sha256,
            "62265168ef01ce0386a52a30991246273950f8ab88263bf74d28d00441f58c84");
}

TEST(MeshFile, IsReadFromAFile) {
  const ScratchFolder folder;
  system::write_file_atomically(folder / "a.obj", cube_obj());
  EXPECT_EQ(read_mesh(folder / "a.obj", {.scale = 1.0}).shape.integrals.volume, 1);
  EXPECT_THROW(read_mesh(folder / "b.obj", {.scale = 1.0}), system::FileError);
  EXPECT_THROW(read_mesh(std::filesystem::path("/dev/zero"), {.scale = 1.0}), system::FileError);
}

}  // namespace
}  // namespace twrench::mesh
