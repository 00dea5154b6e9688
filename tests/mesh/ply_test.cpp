#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/formats.h"
#include "mesh/refusal.h"
#include "mesh/samples.h"

namespace twrench::mesh {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

/// Returns a cube as PLY, with elements and properties that are ignored.
std::string ply(const std::string& format, std::endian order = std::endian::little) {
  const bool is_text = format == "ascii";
  const body::TriangleMesh mesh = cube({0, 0, 0}, 1);
  std::string bytes = "ply\nformat " + format +
                      " 1.0\ncomment TextureFile ../../etc/passwd\n"
                      "element camera 1\nproperty float view\nproperty list uchar short numbers\n"
                      "element vertex 8\nproperty double x\nproperty float y\nproperty short z\n"
                      "property uchar red\nproperty uint8 green\nproperty uchar blue\n"
                      "property int flags\n"
                      "element face 12\nproperty list uchar int vertex_indices\nproperty float q\n"
                      "end_header\n";
  const auto add = [&](auto number) {
    if (is_text)
      bytes += fmt::format("{} ", number);
    else
      append(bytes, number, order);
  };
  const auto end = [&] { bytes += is_text ? "\n" : ""; };
  add(1.5F), add(std::uint8_t{2}), add(std::int16_t{-7}), add(std::int16_t{8}), end();
  for (const Eigen::Vector3d& v : mesh.vertices) {
    add(v.x()), add(static_cast<float>(v.y())), add(static_cast<std::int16_t>(v.z()));
    add(std::uint8_t{255}), add(std::uint8_t{51}), add(std::uint8_t{0}), add(std::int32_t{-1}),
        end();
  }
  for (const auto& triangle : mesh.triangles) {
    add(std::uint8_t{3});
    for (const std::uint32_t corner : triangle) add(static_cast<std::int32_t>(corner));
    add(0.5F), end();
  }
  return bytes;
}

TEST(Ply, IsReadInAllItsFormats) {
  for (const auto& [format, order] : {std::pair("ascii", std::endian::little),
                                      {"binary_little_endian", std::endian::little},
                                      {"binary_big_endian", std::endian::big}}) {
    const std::string bytes = ply(format, order);
    const MeshFile file = read_mesh(bytes, "a.ply", {.scale = 1.0});
    EXPECT_EQ(file.shape.integrals.volume, 1) << format;
    ASSERT_EQ(file.shape.surface->colors.size(), 8U);
    EXPECT_THAT(file.shape.surface->colors[3], ElementsAre(1.0F, 0.2F, 0.0F));
    EXPECT_EQ(read_mesh(bytes, "a.stl", {.scale = 1.0}).shape.integrals.volume, 1) << "misnamed";
    // Missing digits at the end of a text cannot be detected.
    const std::size_t most = bytes.size() - (order == std::endian::little ? 5 : 1);
    for (std::size_t size = 1; size < most; ++size) {
      const std::string part = refusal(bytes.substr(0, size), "a.ply");
      EXPECT_THAT(part, StartsWith("5 ")) << size << " bytes of " << format;
    }
  }
}

std::string replaced(std::string text, const std::string& part, const std::string& by) {
  return text.replace(text.find(part), part.size(), by);
}

TEST(Ply, MayBeginWithAByteOrderMark) {
  for (const char* format : {"ascii", "binary_little_endian"}) {
    const MeshFile file = read_mesh("\xEF\xBB\xBF" + ply(format), "a.ply", {.scale = 1.0});
    EXPECT_EQ(file.shape.integrals.volume, 1) << format;
  }
}

TEST(Ply, BytesAfterTheLastElementAreLeftOutWithANote) {
  for (const char* format : {"ascii", "binary_little_endian"}) {
    EXPECT_THAT(read_mesh(ply(format), "a.ply", {.scale = 1.0}).notes, ElementsAre()) << format;
    const MeshFile longer = read_mesh(ply(format) + "3 0 1 2", "a.ply", {.scale = 1.0});
    EXPECT_EQ(longer.shape.integrals.volume, 1) << format;
    EXPECT_THAT(longer.notes, ElementsAre("the 7 bytes after its last element are left out"));
  }
  EXPECT_THAT(read_mesh(ply("ascii") + " \n\n", "a.ply", {.scale = 1.0}).notes, ElementsAre());
}

TEST(Ply, LinesMayEndWithCr) {
  std::string text = ply("ascii");
  std::ranges::replace(text, '\n', '\r');
  EXPECT_EQ(read_mesh(text, "a.ply", {.scale = 1.0}).shape.integrals.volume, 1);
}

/// Returns the unit cube as triangle strips in one list, separated by -1.
std::string strips(const std::string& format, const std::vector<std::int32_t>& list) {
  const bool is_text = format == "ascii";
  std::string bytes = "ply\nformat " + format +
                      " 1.0\nelement vertex 8\nproperty float x\nproperty float y\n"
                      "property float z\nelement tristrips 1\n"
                      "property list int int vertex_indices\nend_header\n";
  const auto add = [&](auto number) {
    if (is_text)
      bytes += fmt::format("{} ", number);
    else
      append(bytes, number);
  };
  for (const Eigen::Vector3d& v : cube({0, 0, 0}, 1).vertices) {
    for (const double x : v) add(static_cast<float>(x));
    bytes += is_text ? "\n" : "";
  }
  add(static_cast<std::int32_t>(list.size()));
  for (const std::int32_t index : list) add(index);
  return bytes + (is_text ? "\n" : "");
}

TEST(Ply, ReadsTriangleStrips) {
  const std::vector<std::int32_t> six{0, 3, 1, 2, -1, 4, 5, 7, 6, -1, 0, 1, 4, 5, -1,
                                      1, 2, 5, 6, -1, 2, 3, 6, 7, -1, 3, 0, 7, 4, -1};
  // The first strip goes around four faces, and so has turned triangles in several places.
  const std::vector<std::int32_t> three{0,  1, 4, 5, 7, 6,  3, 2, 0, 1, -1,
                                        -1, 1, 2, 5, 6, -1, 3, 0, 7, 4};
  for (const auto& list : {six, three}) {
    for (const char* format : {"ascii", "binary_little_endian"}) {
      const MeshFile file = read_mesh(strips(format, list), "a.ply", {.scale = 1.0});
      EXPECT_EQ(file.shape.integrals.volume, 1) << format;
      EXPECT_EQ(file.shape.surface->triangles.size(), 12U);
      EXPECT_EQ(file.notes.size(), 0U) << "none is turned the other way";
    }
  }
  EXPECT_EQ(refusal(strips("ascii", {0, 3, 8, 2}), "a.ply"),
            "2 a.ply: tristrips 0: it refers to vertex 8, but there are 8 vertices, from 0 on");
  EXPECT_THAT(refusal(strips("ascii", {0, 3, -2, 2}), "a.ply"), HasSubstr("to vertex -2"));
  EXPECT_THAT(refusal(strips("ascii", {0, 3, -1, 1, 2}), "a.ply"), HasSubstr("no triangles"));
}

TEST(Ply, ThatIsBadIsRefused) {
  const std::string good = ply("ascii"), binary = ply("binary_little_endian");
  EXPECT_EQ(refusal(good, "a.ply"), "nothing");
  for (const auto& [part, by, message] :
       {std::tuple("property float y", "property float w",
                   "5 cannot read a.ply: its vertices have no x, y"),
        {"double x", "long x", "5 a.ply:8: 'long' is no type of PLY"},
        {"vertex 8", "vertex 9999999999999",
         "5 cannot read a.ply: it is cut off: its header says "
         "that it has 9999999999999 of 'vertex', for which"},
        {"vertex 8", "vertex x", "5 a.ply:7: 'x' is no number of elements"},
        {"face 12", "vertex 12", "5 cannot read a.ply: its header has two elements 'vertex'"},
        {"format ascii", "format text", "5 a.ply:2: 'text' is no format of PLY"},
        {"format ascii", "comment", "5 a.ply:18: the header has no"},
        {"comment", "commend", "5 a.ply:3: 'commend' is no keyword"},
        {"\n3 0 3 2 ", "\n3 0 3 8 ", "2 a.ply: face 0: it refers to vertex 8, but there are 8"},
        {"\n3 0 3 2 ", "\n3 0 3 -1 ", "2 a.ply: face 0: it refers to vertex -1"},
        {"\n3 0 3 2 ", "\n3 0 3 1.5 ", "2 a.ply: face 0: it refers to vertex 1.5"},
        {"\n3 0 3 2 ", "\n2 0 3 2 ", "2 a.ply: face 0: a face has three corners"},
        {"\n3 0 3 2 ", "\n-3 0 3 2 ", "5 cannot read a.ply: a list cannot have -3 entries"},
        {"\n3 0 3 2 ", "\n4e9 0 3 2 ", "2 a.ply: face 0: it refers to vertex 0.5"},
        {"\n0 0 0 255", "\nnan 0 0 255", "2 a.ply:20: 'nan' is not a finite number"}}) {
    EXPECT_THAT(refusal(replaced(good, part, by), "a.ply"), StartsWith(message)) << by;
  }
  EXPECT_THAT(refusal(replaced(binary, "face 12", "face 4000000000"), "a.ply"),
              HasSubstr("cut off: its header says that it has 4000000000 of 'face'"));
  EXPECT_THAT(refusal("ply\nformat ascii 1.0\nend_header\n", "a.ply"), HasSubstr("no triangles"));
}

TEST(Ply, ThatIsCutOffNamesWhatIsMissing) {
  const std::string text = ply("ascii"), binary = ply("binary_little_endian");
  constexpr std::size_t face = 1 + 3 * 4 + 4;  // bytes
  const auto refused = [](const std::string& whole, std::size_t size) {
    return refusal(whole.substr(0, size), "a.ply");
  };
  const std::string cut = "5 cannot read a.ply: it is cut off: ";
  EXPECT_EQ(refused(binary, binary.size() - 1), cut + "1 of 12 'face' are missing");
  EXPECT_EQ(refused(binary, binary.size() - 2 * face - 1), cut + "3 of 12 'face' are missing");
  const std::size_t last_line = text.rfind('\n', text.size() - 2) + 1;
  EXPECT_EQ(refused(text, last_line), cut + "1 of 12 'face' are missing");
  EXPECT_THAT(refused(text, last_line + 3), HasSubstr("so it is probably cut off"));
  EXPECT_THAT(refused(text, 20), HasSubstr("its header does not end"));
}

TEST(Ply, OfABinaryCoordinateThatIsNotFiniteIsRefused) {
  std::string bytes = ply("binary_little_endian");
  std::string nan;
  append(nan, std::nan(""));
  const std::size_t vertices = bytes.find("end_header\n") + 11 + 4 + 1 + 2 * 2;
  bytes.replace(vertices + 2 * 21, 8, nan);  // of 8 + 4 + 2 + 3 + 4 bytes each
  EXPECT_EQ(refusal(bytes, "a.ply"), "2 a.ply: vertex 2: a coordinate is not a finite number");
}

}  // namespace
}  // namespace twrench::mesh
