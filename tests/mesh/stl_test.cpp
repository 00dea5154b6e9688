#include "mesh/stl.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "mesh/refusal.h"
#include "mesh/samples.h"

namespace twrench::mesh {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

const body::TriangleMesh unit_cube = cube({0, 0, 0}, 1);

TEST(Stl, BinaryMayBeginWithSolid) {
  for (const char* header : {"exported", "solid cube", "solid\n facet", ""}) {
    const MeshFile file = read_mesh(binary_stl(unit_cube, header), "a.stl", {.scale = 1.0});
    EXPECT_EQ(file.shape.integrals.volume, 1) << header;
  }
}

TEST(Stl, TextIsTheSame) {
  const std::string text = text_stl(unit_cube);
  EXPECT_EQ(read_mesh(text, "a.stl", {.scale = 1.0}).shape.integrals.volume, 1);
  std::string upper = text;
  std::ranges::transform(upper, upper.begin(), [](unsigned char c) {
    return static_cast<char>(c == '\n' ? c : std::toupper(c));
  });
  EXPECT_EQ(read_mesh(upper, "A.STL", {.scale = 1.0}).shape.integrals.volume, 1);
  const std::string two = text + text_stl(cube({5, 0, 0}, 1));
  EXPECT_EQ(read_mesh(two, "a.stl", {.scale = 1.0}).shape.integrals.volume, 2) << "two solids";
}

TEST(Stl, ThatIsCutOffIsRefused) {
  const std::string whole = binary_stl(unit_cube, "solid cube");
  EXPECT_EQ(refusal(whole.substr(0, 300), "a.stl"),
            "5 cannot read a.stl: it is cut off: 12 triangles take 684 bytes, but it has 300");
  EXPECT_THAT(refusal(whole + "x", "a.stl"), HasSubstr("no STL file, or damaged"));
  EXPECT_THAT(refusal(whole.substr(0, 50), "a.stl"), HasSubstr("50 bytes are no STL file"));
  const std::string text = text_stl(unit_cube);
  EXPECT_EQ(refusal(text.substr(0, text.find("endsolid")), "a.stl"),
            "5 cannot read a.stl: it is cut off: it ends after 12 triangles without 'endsolid'");
  EXPECT_THAT(refusal(text.substr(0, text.rfind("vertex")), "a.stl"),
              HasSubstr("cut off: it ends after 11 triangles"));
}

TEST(Stl, TextWithoutLineEndsIsNoDamagedBinary) {
  std::string text = text_stl(unit_cube);
  std::ranges::replace(text, '\n', ' ');
  EXPECT_EQ(refusal(text, "a.stl"),
            "5 cannot read a.stl: it begins as a text STL, but no line begins with 'facet'");
}

// No memory is allocated for the number of triangles that a header claims.
TEST(Stl, ThatClaimsFourGigabytesIsRefused) {
  std::string bytes = binary_stl(unit_cube);
  bytes.replace(80, 4, "\xff\xff\xff\xff");
  EXPECT_EQ(refusal(bytes, "a.stl"),
            "5 cannot read a.stl: it is cut off: 4294967295 triangles take 214748364834 bytes, but "
            "it has 684");
}

TEST(Stl, OfBadNumbersIsRefusedWithTheirPlace) {
  body::TriangleMesh mesh = unit_cube;
  mesh.vertices[6].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal(binary_stl(mesh), "a.stl"),
            "2 a.stl: triangle 3: a coordinate is not a finite number");
  EXPECT_THAT(refusal(text_stl(mesh), "a.stl"),
              AllOf(StartsWith("2 a.stl:20: "), HasSubstr("'nan' is not a finite number")));
  EXPECT_EQ(refusal("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0\n", "a.stl"),
            "5 a.stl:4: a number is missing");
  EXPECT_EQ(refusal("solid a\nfacet normal 0 0 1\nvertex 0 0 0\n", "a.stl"),
            "5 a.stl:3: 'outer' should stand here, not 'vertex'");
}

}  // namespace
}  // namespace twrench::mesh
