#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "mesh/refusal.h"
#include "mesh/samples.h"

namespace twrench::mesh {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

std::string positions_of(const body::TriangleMesh& mesh) {
  std::string text;
  for (const Vector3d& v : mesh.vertices) text += fmt::format("{} {} {} ", v.x(), v.y(), v.z());
  return text;
}

/// The parts of a document; each test changes some.
struct Document {
  std::string declaration = "<?xml version=\"1.0\" encoding=\"utf-8\"?>";
  std::string asset = "<unit name=\"millimeter\" meter=\"0.001\"/><up_axis>Z_UP</up_axis>";
  std::string positions = positions_of(cube({0, 0, 0}, 1.0));
  std::string primitives;
  std::string library = {};
  std::string nodes = "<node><instance_geometry url=\"#g\"/></node>";

  std::string text() const {
    const auto numbers = std::ranges::count(positions, ' ');
    return declaration + "<COLLADA version=\"1.4.1\"><asset>" + asset +
           "</asset><library_geometries><geometry id=\"g\"><mesh><source id=\"s\">"
           "<float_array id=\"f\">" +
           positions +
           fmt::format(
               "</float_array><technique_common><accessor source=\"#f\" count=\"{}\" "
               "stride=\"3\"/></technique_common></source>",
               numbers / 3) +
           "<vertices id=\"v\"><input semantic=\"POSITION\" source=\"#s\"/></vertices>" +
           primitives + "</mesh></geometry></library_geometries>" + library +
           "<library_visual_scenes><visual_scene id=\"w\">" + nodes +
           "</visual_scene></library_visual_scenes><scene><instance_visual_scene url=\"#w\"/>"
           "</scene></COLLADA>";
  }
};

const std::string vertex_input = "<input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/>";

std::string triangles_of(const body::TriangleMesh& mesh) {
  std::string text = "<triangles>" + vertex_input + "<p>";
  for (const auto& [a, b, c] : mesh.triangles) text += fmt::format("{} {} {} ", a, b, c);
  return text + "</p></triangles>";
}

Document document_of(const body::TriangleMesh& mesh) {
  return {.positions = positions_of(mesh), .primitives = triangles_of(mesh)};
}

Document cube_document() { return document_of(cube({0, 0, 0}, 1.0)); }

MeshFile read(const Document& document, const ReadOptions& options = {}) {
  return read_mesh(document.text(), "a.dae", options);
}

TEST(Collada, HasItsUnit) {
  Document document = cube_document();
  EXPECT_NEAR(read(document).shape.integrals.volume, 1e-3, 1e-18);
  EXPECT_NEAR(read(document, {.scale = 2.54}).shape.integrals.volume, 2.54 * 2.54 * 2.54, 1e-13);
  document.asset = "";  // metres
  EXPECT_NEAR(read(document).shape.integrals.volume, 1e6, 1e-9);
  for (const char* meter : {"0", "-1", "nan", "inf", "1,5", ""}) {
    document.asset = fmt::format("<unit meter=\"{}\"/>", meter);
    EXPECT_THAT(refusal(document.text(), "a.dae"), StartsWith("2 a.dae: <unit>: its meter is no"));
  }
}

// Every number is kept as a double, so the integrals are those of the same body in OBJ, near the
// origin and 100 times its size away.
TEST(Collada, IsAsExactAsObj) {
  body::TriangleMesh wedge;
  wedge.vertices = {{0.1, 0, 0},   {1.3, 0, 0},   {0.1, 0.7, 0},
                    {0.1, 0, 2.1}, {1.3, 0, 2.1}, {0.1, 0.7, 2.1}};
  wedge.triangles = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3},
                     {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
  for (const body::TriangleMesh& mesh :
       {cube({-0.3, 0.1, 0.7}, 1.1), wedge, moved(wedge, {123.4, -210.7, 77.7})}) {
    const auto a = read(document_of(mesh)).shape.integrals;
    const auto b = read_mesh(obj_of(mesh), "a.obj", {.scale = 0.1}).shape.integrals;
    EXPECT_EQ(a.volume, b.volume);
    EXPECT_EQ(a.centroid, b.centroid);
    EXPECT_EQ(a.inertia, b.inertia);
  }
}

TEST(Collada, AppliesTransformsInOrder) {
  Document document = cube_document();
  document.nodes =
      "<node><translate>10 0 0</translate><rotate>0 0 2 90</rotate><scale>1 2 -3</scale>"
      "<node><matrix>1 0 0 1 0 1 0 0 0 0 1 0 0 0 0 1</matrix>"
      "<instance_geometry url=\"#g\"/></node></node>";
  const MeshFile file = read(document, {.scale = 1.0});
  EXPECT_NEAR(file.shape.integrals.volume, 6, 1e-14);
  // (0.5, 0.5, 0.5) moved to x = 1.5, scaled to (1.5, 1, -1.5), turned to (-1, 1.5), moved by 10.
  EXPECT_LE((file.shape.integrals.centroid - Vector3d(9, 1.5, -1.5)).norm(), 1e-14);
  EXPECT_THAT(file.notes, ElementsAre());  // It is not inside out.
}

TEST(Collada, KeepsItsAxesWhateverIsUp) {
  Document document = cube_document();
  document.nodes = "<node><scale>1 2 3</scale><instance_geometry url=\"#g\"/></node>";
  const Matrix3d z_up = read(document, {.scale = 1.0}).shape.integrals.inertia;
  document.asset = "<up_axis>Y_UP</up_axis>";
  EXPECT_EQ(read(document, {.scale = 1.0}).shape.integrals.inertia, z_up);
}

TEST(Collada, RepeatsNodesOfItsLibrary) {
  Document document = cube_document();
  document.library =
      "<library_nodes><node id=\"k\"><instance_geometry url=\"#g\"/></node></library_nodes>";
  document.nodes =
      "<node><instance_node url=\"#k\"/></node>"
      "<node><translate>5 0 0</translate><instance_node url=\"#k\"/></node>";
  const MeshFile file = read(document, {.scale = 1.0});
  EXPECT_NEAR(file.shape.integrals.volume, 2, 1e-14);
  EXPECT_EQ(file.components, 2U);
}

// The faces 1 4 3 2 and so on of cube_obj(), with the indices of normals between.
TEST(Collada, ReadsAllKindsOfFaces) {
  Document document;
  const std::string two = "<input semantic=\"NORMAL\" source=\"#n\" offset=\"1\"/>" + vertex_input;
  for (const std::string& faces :
       {"<polylist>" + vertex_input +
            "<vcount>4 4 4 4 4 4</vcount><p>0 3 2 1 4 5 6 7 0 1 5 4 "
            "1 2 6 5 2 3 7 6 3 0 4 7</p></polylist>",
        "<polygons>" + two +
            "<p>0 9 3 9 2 9 1 9</p><p>4 9 5 9 6 9 7 9</p><p>0 9 1 9 5 9 4 9</p>"
            "<p>1 9 2 9 6 9 5 9</p><p>2 9 3 9 7 9 6 9</p><p>3 9 0 9 4 9 7 9</p></polygons>",
        "<trifans>" + vertex_input +
            "<p>0 3 2 1</p><p>4 5 6 7</p><p>0 1 5 4</p><p>1 2 6 5</p>"
            "</trifans><tristrips>" +
            vertex_input + "<p>2 3 6 7</p><p>3 0 7 4</p></tristrips>"}) {
    document.primitives = faces + "<lines>" + vertex_input + "<p>0 1</p></lines>";
    const MeshFile file = read(document, {.scale = 1.0});
    EXPECT_NEAR(file.shape.integrals.volume, 1, 1e-15);
    EXPECT_THAT(file.notes, ElementsAre("1 of its primitives are lines, and are left out"));
  }
}

TEST(Collada, RefusesDamagedFilesInOneLine) {
  const std::string whole = cube_document().text();
  for (std::size_t length = 0; length + 1 < whole.size(); ++length) {
    EXPECT_THAT(refusal(whole.substr(0, length), "a.dae"),
                AllOf(StartsWith("5 cannot read a.dae"), testing::Not(HasSubstr("\n"))));
  }
  EXPECT_THAT(refusal("<svg/>", "a.dae"), HasSubstr("no COLLADA document: its root is <svg>"));
  EXPECT_THAT(refusal("<COLLADA/>", "a.dae"), HasSubstr("refers to no visual_scene"));
}

TEST(Collada, RefusesInvalidNumbers) {
  Document document = cube_document();
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = document.text();
    text.replace(text.find(from), from.size(), to);
    return refusal(text, "a.dae");
  };
  EXPECT_THAT(with(">0 0 0 1 ", ">0 0 0 NaN "), HasSubstr("<vertices id=\"v\">: vertex 1: a coor"));
  EXPECT_THAT(with(">0 0 0 1 ", ">0 0 0 1e999 "), HasSubstr("'1e999' is no number"));
  EXPECT_THAT(with("count=\"8\"", "count=\"18446744073709551615\""),
              HasSubstr("its positions need"));
  EXPECT_THAT(with("stride=\"3\"", "stride=\"0\""), HasSubstr("its positions need"));
  EXPECT_THAT(with("<p>0 3", "<p>0 8"), HasSubstr("it refers to vertex 8, but there are 8"));
  EXPECT_THAT(with("<p>0 3", "<p>0 -1"), HasSubstr("'-1' is no index"));
  EXPECT_THAT(with("#g", "#f"), HasSubstr("refers to '#f', which is no geometry"));
  EXPECT_THAT(with("#g", "b.dae#g"), HasSubstr("refers to 'b.dae#g'"));
  EXPECT_THAT(with("<node>", "<node><skew>1 2 3 4 5 6 7</skew>"), HasSubstr("<skew>: this trans"));
  EXPECT_THAT(with("<node>", "<node><scale>inf 1 1</scale>"), HasSubstr("it has no 3 finite"));
}

TEST(Collada, ExpandsNoEntities) {
  Document document = cube_document();
  document.declaration =
      "<?xml version=\"1.0\"?><!DOCTYPE x [<!ENTITY a \"0 0\"><!ENTITY b \"&a;&a;&a;\">]>";
  EXPECT_EQ(refusal(document.text(), "a.dae"), "nothing");
  document.positions = "&b; " + document.positions;
  EXPECT_THAT(refusal(document.text(), "a.dae"), HasSubstr("'&b;' is no number"));
}

TEST(Collada, BoundsItsWork) {
  Document document = cube_document();
  std::string open, close;
  for (int i = 0; i < 1'000'000; ++i) {
    open += "<node>";
    close += "</node>";
  }
  document.nodes = open + close;
  EXPECT_THAT(refusal(document.text(), "a.dae"), HasSubstr("nested more than 1000 deep"));
  document.nodes = "<node id=\"k0\"><instance_node url=\"#k0\"/></node>";
  EXPECT_THAT(refusal(document.text(), "a.dae"), HasSubstr("nested more than 1000 deep"));
  const auto doubled = [&](const std::string& last) {
    document.library = "<library_nodes>";
    for (int i = 0; i < 40; ++i) {
      const std::string next = fmt::format("<instance_node url=\"#k{}\"/>", i + 1);
      document.library += fmt::format("<node id=\"k{}\">{}{}</node>", i, next, next);
    }
    document.library += "<node id=\"k40\">" + last + "</node></library_nodes>";
    document.nodes = "<node><instance_node url=\"#k0\"/></node>";
    return refusal(document.text(), "a.dae");
  };
  EXPECT_THAT(doubled(""), HasSubstr("repeated more than 1000000 times"));
  EXPECT_THAT(doubled("<instance_geometry url=\"#g\"/>"), HasSubstr("to more than 3000000 tri"));
}

}  // namespace
}  // namespace twrench::mesh
