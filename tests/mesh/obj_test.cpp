#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/formats.h"
#include "mesh/refusal.h"
#include "mesh/samples.h"

namespace twrench::mesh {
namespace {

using Eigen::Vector3d;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

body::TriangleMesh mesh_of(const std::string& text) { return read_obj({"a.obj", text, {}}).mesh; }

TEST(Obj, ReadsVerticesAndFaces) {
  const auto mesh = mesh_of(
      "# a comment\r\nmtllib /etc/passwd\no a\nv 1 +2 -3e-1\r\n\tv 0 0 1\nv 0 1 0 1\n"
      "vn 0 0 1\nvt 0 0\nusemtl x\ns off\nf 1/1/1 2//1 3/1\nf -3 -2 -1");
  EXPECT_THAT(mesh.vertices,
              ElementsAre(Vector3d(1, 2, -0.3), Vector3d(0, 0, 1), Vector3d(0, 1, 0)));
  EXPECT_THAT(mesh.triangles, ElementsAre(std::array{0U, 1U, 2U}, std::array{0U, 1U, 2U}));
  EXPECT_THAT(mesh.colors, SizeIs(0));
}

TEST(Obj, SplitsPolygons) {
  const auto mesh = mesh_of("v 0 0 0\nv 1 0 0\nv 2 1 0\nv 1 2 0\nv 0 1 0\nf 1 2 3 4 5\n");
  EXPECT_THAT(mesh.triangles,
              ElementsAre(std::array{0U, 1U, 2U}, std::array{0U, 2U, 3U}, std::array{0U, 3U, 4U}));
}

TEST(Obj, SplitsConcavePolygonsWithin) {
  const std::string vertices = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 0.5 0\n", face = "f 1 2 3 4\n";
  for (const std::string& text : {vertices + face, face + vertices}) {
    EXPECT_THAT(mesh_of(text).triangles,
                testing::UnorderedElementsAre(std::array{3U, 0U, 1U}, std::array{3U, 1U, 2U}));
  }
}

TEST(Obj, MayNameVerticesThatComeLater) {
  EXPECT_THAT(mesh_of("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n").triangles, SizeIs(1));
}

TEST(Obj, ReadsColors) {
  const auto mesh = mesh_of("v 0 0 0\nv 1 0 0 1 0.5 0\nv 0 1 0 2 -1 0.25\nv 0 0 1\n");
  EXPECT_THAT(mesh.colors, ElementsAre(std::array{1.F, 1.F, 1.F}, std::array{1.F, 0.5F, 0.F},
                                       std::array{1.F, 0.F, 0.25F}, std::array{1.F, 1.F, 1.F}));
}

TEST(Obj, MayBeginWithAByteOrderMark) {
  const std::string tetrahedron =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 5 5 5\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
  for (const char* before : {"", "\xEF\xBB\xBF", "\xEF\xBB\xBF\n"}) {
    const MeshFile file = read_mesh(before + tetrahedron, "a.obj", {.scale = 1.0});
    EXPECT_DOUBLE_EQ(file.shape.integrals.volume, 1.0 / 6) << before;
  }
}

TEST(Obj, LinesMayContinueAfterABackslash) {
  const auto mesh = mesh_of(
      "v 1 \\\n2\\\r\n 3 # a comment\nv 0 0\\\n\\\n1\nv 0 1 0\nf 1/1 \\\n2/2\\\n3/3\nf -3 -2 -1 "
      "\\\n");
  EXPECT_THAT(mesh.vertices, ElementsAre(Vector3d(1, 2, 3), Vector3d(0, 0, 1), Vector3d(0, 1, 0)));
  EXPECT_THAT(mesh.triangles, ElementsAre(std::array{0U, 1U, 2U}, std::array{0U, 1U, 2U}));
}

TEST(Obj, LinesMayEndWithAComment) {
  const auto mesh = mesh_of(
      "v 1 2 3# a\nv 0 0 1 # 0.5 0.5 0.5\nv 0 1 0 1 0 0 #\n#f 1 2 2\nf 1 2 3 # C:\\\nf 1//1 2//1 "
      "3//1#4\n");
  EXPECT_THAT(mesh.vertices, ElementsAre(Vector3d(1, 2, 3), Vector3d(0, 0, 1), Vector3d(0, 1, 0)));
  EXPECT_THAT(mesh.triangles, ElementsAre(std::array{0U, 1U, 2U}, std::array{0U, 1U, 2U}));
  EXPECT_THAT(mesh.colors, ElementsAre(std::array{1.F, 1.F, 1.F}, std::array{1.F, 1.F, 1.F},
                                       std::array{1.F, 0.F, 0.F}));
}

TEST(Obj, LinesMayEndWithCr) {
  EXPECT_THAT(mesh_of("v 0 0 0\rv 1 0 0\rv 0 1 0\r# a\rf 1 \\\r2 3\r").triangles, SizeIs(1));
}

TEST(Obj, CountsAllLinesOfAContinuedOne) {
  EXPECT_EQ(refusal("v 0 \\\n0 \\\n0\nv 1 x 0\n", "a.obj"), "5 a.obj:4: 'x' is no number");
  EXPECT_EQ(refusal("v 0 0 0\nf 1 \\\n1 \\\n2\n", "a.obj"),
            "2 a.obj:2: the face refers to vertex 2, but there are 1 vertices");
}

TEST(Obj, OfABadLineIsRefusedWithItsPlace) {
  const std::string good = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (const auto& [line, message] : {
           std::pair("v 1 2", "5 a.obj:4: a number is missing"),
           {"v 1 2 x", "5 a.obj:4: 'x' is no number"},
           {"v 1 2 3x", "5 a.obj:4: '3x' is no number"},
           {"v 1 nan 3", "2 a.obj:4: 'nan' is not a finite number"},
           {"v 1 2 -inf", "2 a.obj:4: '-inf' is not a finite number"},
           {"v 1 2 1e999", "2 a.obj:4: '1e999' is not a finite number"},
           {"f 1 2 \\ 3", "5 a.obj:4: '\\' is no index of a vertex"},
           {"f 1 2 3 \\ ", "5 a.obj:4: '\\' is no index of a vertex"},
           {"f 1 2", "2 a.obj:4: a face has three corners at least"},
           {"f 1 2 x", "5 a.obj:4: 'x' is no index of a vertex"},
           {"f 1 2 0", "2 a.obj:4: the face refers to vertex 0, but there are 3 vertices"},
           {"f 1 2 -4", "2 a.obj:4: the face refers to vertex -4, but there are 3"},
           {"f 1 2 4", "2 a.obj:4: the face refers to vertex 4, but there are 3"},
           {"f 1 2 99999999999999999999", "5 a.obj:4: '99999999999999999999' is no index"},
           {"f 1 2 9999999999", "2 a.obj:4: the face refers to vertex 9999999999"},
       }) {
    EXPECT_THAT(refusal(good + line + "\n", "a.obj"), testing::StartsWith(message));
  }
  EXPECT_EQ(refusal(good, "a.obj"), "2 a.obj: it has no triangles");
  for (const char* cut : {"v 1 2", "v 1 2 -", "f", "f 1 2"}) {
    EXPECT_THAT(refusal(good + cut, "a.obj"),
                testing::HasSubstr("the file ends in this line, so it is probably cut off"));
    EXPECT_THAT(refusal(good + cut + "\n", "a.obj"), testing::Not(testing::HasSubstr("cut off")));
  }
  EXPECT_EQ(refusal("", "a.obj"), "5 cannot read a.obj: it is empty");
}

}  // namespace
}  // namespace twrench::mesh
