#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "mesh/formats.h"
#include "mesh/refusal.h"
#include "mesh/samples.h"

namespace twrench::mesh {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
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
            "5 cannot read a.stl: it is cut off: 8 of 12 triangles are missing, because it has 300 "
            "bytes of 684");
  EXPECT_THAT(refusal(whole.substr(0, 50), "a.stl"), HasSubstr("50 bytes are no STL file"));
  const std::string text = text_stl(unit_cube);
  EXPECT_EQ(refusal(text.substr(0, text.find("endsolid")), "a.stl"),
            "5 cannot read a.stl: it is cut off: it ends after 12 triangles without 'endsolid'");
  EXPECT_THAT(refusal(text.substr(0, text.rfind("vertex")), "a.stl"),
              HasSubstr("cut off: it ends after 11 triangles"));
  for (const char* word : {"vertex 1", "loop", "facet"}) {
    const std::size_t within = text.rfind(word) + std::string_view(word).size() - 1;
    EXPECT_THAT(refusal(text.substr(0, within), "a.stl"), HasSubstr("cut off")) << within;
  }
}

TEST(Stl, WithoutTrianglesIsRefused) {
  EXPECT_EQ(refusal(std::string(100, '\0'), "a.stl"),
            "5 cannot read a.stl: it is no STL file, or damaged: 0 triangles take 84 bytes, but it "
            "has 100");
}

TEST(Stl, TextMayHaveAByteOrderMarkOrBlankLinesBeforeIt) {
  const std::string text = text_stl(unit_cube);
  for (const char* before : {"\xEF\xBB\xBF", "\n  ", "\r\n\r\n\t", "\xEF\xBB\xBF \n"}) {
    const MeshFile file = read_mesh(before + text, "a.stl", {.scale = 1.0});
    EXPECT_EQ(file.shape.integrals.volume, 1) << before;
    EXPECT_THAT(file.notes, IsEmpty());
  }
}

TEST(Stl, TextMayHaveLinesAfterItsEnd) {
  const std::string text = text_stl(unit_cube);
  for (const char* after : {"\x1A", "made by hand\n", "\n; end\n\n; of file\n"}) {
    const MeshFile file = read_mesh(text + after, "a.stl", {.scale = 1.0});
    EXPECT_EQ(file.shape.integrals.volume, 1) << after;
    EXPECT_THAT(file.notes, ElementsAre(testing::HasSubstr("after 'endsolid', is left out")));
  }
  EXPECT_THAT(read_mesh(text + "; end\n", "a.stl", {.scale = 1.0}).notes,
              ElementsAre("the text from line 87 on, after 'endsolid', is left out"));
  EXPECT_EQ(refusal(text + "sold b\n" + text.substr(text.find(" facet")), "a.stl"),
            "5 a.stl:87: 'solid' should stand here, not 'sold'");
  EXPECT_EQ(refusal(text + "facet normal 0 0 0\n", "a.stl"),
            "5 a.stl:87: 'solid' should stand here, not 'facet'");
}

TEST(Stl, OfOtherTextIsNoDamagedBinary) {
  EXPECT_EQ(refusal(obj_of(unit_cube), "a.stl"),
            "5 cannot read a.stl: it is text, but does not begin with 'solid'");
  EXPECT_EQ(refusal("# a comment\n" + text_stl(unit_cube), "a.stl"),
            "5 cannot read a.stl: it is text, but does not begin with 'solid'");
}

TEST(Stl, LinesMayEndWithCr) {
  std::string text = text_stl(unit_cube);
  std::ranges::replace(text, '\n', '\r');
  EXPECT_EQ(read_mesh(text, "a.stl", {.scale = 1.0}).shape.integrals.volume, 1);
}

// A header may look like text or like another kind of file.
TEST(Stl, MayHaveBytesAfterItsLastTriangle) {
  for (const char* header : {"exported", "solid cube", "solid\n facet", " \n solid x"}) {
    const std::string bytes = binary_stl(unit_cube, header);
    const MeshFile file = read_mesh(bytes + "ab", "a.stl", {.scale = 1.0});
    EXPECT_EQ(file.shape.integrals.volume, 1) << header;
    EXPECT_THAT(file.notes, ElementsAre("the 2 bytes after its last triangle are left out"));
  }
  EXPECT_EQ(refusal(binary_stl(unit_cube, "GIF89a"), "a.stl"), "nothing");
}

/// Returns a binary STL in which the attributes of triangle i have payloads[i] bytes, as they
/// state.
std::string stl_with_payload(const std::vector<std::uint16_t>& payloads) {
  const std::string plain = binary_stl(unit_cube);
  std::string bytes = plain.substr(0, 84);
  for (std::size_t i = 0; i < payloads.size(); ++i) {
    bytes += plain.substr(84 + 50 * i, 48);
    append(bytes, payloads[i]);
    bytes += std::string(payloads[i], '\x12');
  }
  return bytes;
}

TEST(Stl, MayHaveAttributesThatStateTheirLength) {
  for (const auto& payloads : {std::vector<std::uint16_t>(12, 2),
                               {0, 0, 4, 0, 300, 0, 1, 0, 0, 0, 0, 0},
                               {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 50}}) {
    const std::string bytes = stl_with_payload(payloads);
    const MeshFile file = read_mesh(bytes, "a.stl", {.scale = 1.0});
    EXPECT_EQ(file.shape.integrals.volume, 1);
    EXPECT_THAT(file.notes,
                ElementsAre(fmt::format("the attributes of its triangles, {} bytes, are left out",
                                        bytes.size() - 684)));
    EXPECT_THAT(refusal(bytes + "x", "a.stl"), HasSubstr("may be attributes of the triangles or"));
  }
}

TEST(Stl, MayHaveColorsInItsAttributes) {
  std::string bytes = binary_stl(unit_cube);
  for (std::size_t i = 0; i < 12; ++i) bytes.replace(84 + 50 * i + 48, 2, "\xff\x7f");
  EXPECT_EQ(refusal(bytes, "a.stl"), "nothing");
  EXPECT_THAT(read_mesh(bytes + "ab", "a.stl", {.scale = 1.0}).notes,
              ElementsAre("the 2 bytes after its last triangle are left out"));
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
            "5 cannot read a.stl: it is cut off: 4294967283 of 4294967295 triangles are missing, "
            "because it has 684 bytes of 214748364834");
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
