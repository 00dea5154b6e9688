#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "mesh/refusal.h"
#include "mesh/samples.h"
#include "zip_file.h"

namespace twrench::mesh {
namespace {

using Eigen::Vector3d;
using testing::AllOf;
using testing::AnyOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

const std::string name_of_root = "3D/3dmodel.model";

const std::string relations =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>"
    "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
    "<Relationship Target=\"/Metadata/thumbnail.png\" Id=\"a\" Type=\"http://x/thumbnail\"/>"
    "<Relationship Target=\"/3D/3dmodel.model\" Id=\"b\" "
    "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>";

/// The parts of a model; each test changes some.
struct Model {
  std::string attributes = "unit=\"millimeter\" xml:lang=\"en-US\"";
  std::string objects;
  std::string items = "<item objectid=\"1\"/>";

  std::string text() const {
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?><model " + attributes +
           " xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
           "xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\" "
           "xmlns:b=\"http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02\">"
           "<metadata name=\"Title\">a</metadata><resources>" +
           objects + "</resources><build>" + items + "</build></model>";
  }
};

std::string object_of(const body::TriangleMesh& mesh, int id, const std::string& attributes = {}) {
  std::string text = fmt::format("<object id=\"{}\" {}><mesh><vertices>", id, attributes);
  for (const Vector3d& v : mesh.vertices)
    text += fmt::format("<vertex x=\"{}\" y=\"{}\" z=\"{}\"/>", v.x(), v.y(), v.z());
  text += "</vertices><triangles>";
  for (const auto& [a, b, c] : mesh.triangles)
    text += fmt::format("<triangle v1=\"{}\" v2=\"{}\" v3=\"{}\" pid=\"5\"/>", a, b, c);
  return text + "</triangles></mesh></object>";
}

std::string object_of(const std::string& components, int id) {
  return fmt::format("<object id=\"{}\"><components>{}</components></object>", id, components);
}

Model model_of(const body::TriangleMesh& mesh) { return {.objects = object_of(mesh, 1)}; }
Model cube_model() { return model_of(cube({0, 0, 0}, 1.0)); }

std::string file_of(const std::string& model) {
  return archive_of({{name_of_root, model}, {"_rels/.rels", relations}});
}

MeshFile read(const Model& model, const ReadOptions& options = {}) {
  return read_mesh(file_of(model.text()), "a.3mf", options);
}

std::string refusal_of(const Model& model) { return refusal(file_of(model.text()), "a.3mf"); }

TEST(ThreeMf, HasItsUnit) {
  Model model = cube_model();
  for (const auto& [unit, length] : {std::pair("unit=\"micron\"", 1e-4),
                                     {"unit=\"millimeter\"", 0.1},
                                     {"", 0.1},
                                     {"unit=\"centimeter\"", 1.0},
                                     {"unit=\"inch\"", 2.54},
                                     {"unit=\"foot\"", 30.48},
                                     {"unit=\"meter\"", 100.0}}) {
    model.attributes = unit;
    EXPECT_DOUBLE_EQ(read(model).shape.integrals.volume, length * length * length) << unit;
  }
  EXPECT_DOUBLE_EQ(read(model, {.scale = 3.0}).shape.integrals.volume, 27.0);
  model.attributes = "unit=\"milimeter\"";
  EXPECT_THAT(refusal_of(model), AllOf(StartsWith("2 a.3mf: 3D/3dmodel.model: unit: unknown name "
                                                  "'milimeter'"),
                                       Not(HasSubstr("\n"))));
}

// Every number is kept as a double, so the integrals are those of the same body in OBJ, near the
// origin and 100 times its size away. A binary STL has floats, which these numbers are.
TEST(ThreeMf, IsAsExactAsObjAndStl) {
  body::TriangleMesh wedge;
  wedge.vertices = {{0.125, 0, 0},   {1.5, 0, 0},   {0.125, 0.75, 0},
                    {0.125, 0, 2.5}, {1.5, 0, 2.5}, {0.125, 0.75, 2.5}};
  wedge.triangles = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3},
                     {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
  const auto expect_equal = [](const MeshFile& a, const MeshFile& b) {
    EXPECT_EQ(a.shape.integrals.volume, b.shape.integrals.volume);
    EXPECT_EQ(a.shape.integrals.centroid, b.shape.integrals.centroid);
    EXPECT_EQ(a.shape.integrals.inertia, b.shape.integrals.inertia);
  };
  for (const body::TriangleMesh& mesh : {wedge, moved(wedge, {128.5, -256.25, 64})}) {
    const MeshFile file = read(model_of(mesh));
    expect_equal(file, read_mesh(obj_of(mesh), "a.obj", {.scale = 0.1}));
    expect_equal(file, read_mesh(binary_stl(mesh), "a.stl", {.scale = 0.1}));
  }
  for (const body::TriangleMesh& mesh :
       {cube({-0.3, 0.1, 0.7}, 1.1), moved(cube({-0.3, 0.1, 0.7}, 1.1), {123.4, -210.7, 77.7})})
    expect_equal(read(model_of(mesh)), read_mesh(obj_of(mesh), "a.obj", {.scale = 0.1}));
}

TEST(ThreeMf, PlacesItemsAndComponents) {
  Model model = cube_model();
  model.objects +=
      object_of("<component objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 1 0 0\"/>", 2);
  // Row vectors: x becomes 2 y, and y becomes -x.
  model.items = "<item objectid=\"2\" transform=\"0 2 0 -1 0 0 0 0 -3 10 0 0\"/>";
  const MeshFile file = read(model, {.scale = 1.0});
  EXPECT_NEAR(file.shape.integrals.volume, 6, 1e-14);
  // (0.5, 0.5, 0.5) moved to x = 1.5, then (-0.5, 3, -1.5), moved by 10.
  EXPECT_LE((file.shape.integrals.centroid - Vector3d(9.5, 3, -1.5)).norm(), 1e-14);
  EXPECT_THAT(file.notes, ElementsAre());  // It is not inside out.
  model.items += "<item objectid=\"1\"/>";
  EXPECT_EQ(read(model, {.scale = 1.0}).components, 2U);
}

TEST(ThreeMf, LeavesOutSupports) {
  Model model = cube_model();
  const body::TriangleMesh other = cube({5, 0, 0}, 1.0);
  model.objects += object_of(other, 2, "type=\"support\"") + object_of(other, 3, "type=\"other\"") +
                   object_of(moved(other, {5, 0, 0}), 4, "type=\"solidsupport\"");
  model.items +=
      "<item objectid=\"2\"/><item objectid=\"2\"/><item objectid=\"3\"/><item objectid=\"4\"/>";
  const MeshFile file = read(model, {.scale = 1.0});
  EXPECT_NEAR(file.shape.integrals.volume, 2, 1e-14);
  EXPECT_THAT(file.notes,
              ElementsAre("1 of its objects are of the type 'other', and are left out",
                          "2 of its objects are of the type 'support', and are left out"));
  model.items = "<item objectid=\"2\"/>";
  EXPECT_THAT(refusal_of(model), HasSubstr("it has no triangles"));
}

TEST(ThreeMf, LeavesOutBeamLattices) {
  Model model = cube_model();
  model.objects.insert(model.objects.find("</mesh>"), "<b:beamlattice/>");
  EXPECT_THAT(read(model).notes, ElementsAre("its 1 beam lattices are left out"));
  model.attributes += " requiredextensions=\"p b\"";
  EXPECT_THAT(refusal_of(model), HasSubstr("it needs the extension 'http://schemas.microsoft.com/"
                                           "3dmanufacturing/beamlattice/2017/02', which is not"));
  model.attributes = "requiredextensions=\"q\"";
  EXPECT_THAT(refusal_of(model), HasSubstr("it needs the extension 'q', which is not read"));
}

TEST(ThreeMf, ReadsPartsInOtherFilesOfTheArchive) {
  Model model, part = cube_model();
  model.attributes = "unit=\"centimeter\" requiredextensions=\"p\"";
  model.objects = object_of("<component objectid=\"1\" p:path=\"/3D/Objects/PART.model\"/>", 7);
  model.items =
      "<item objectid=\"7\"/>"
      "<item objectid=\"1\" p:path=\"/3D/Objects/part.model\" "
      "transform=\"1 0 0 0 1 0 0 0 1 5 0 0\"/>";
  const auto file = [&] {
    return archive_of({{name_of_root, model.text()},
                       {"_rels/.rels", relations},
                       {"3D/Objects/part.model", part.text()}});
  };
  // The part is in millimetres.
  EXPECT_NEAR(read_mesh(file(), "a.3mf", {}).shape.integrals.volume, 2e-3, 1e-17);
  part.objects = object_of("<component objectid=\"1\" p:path=\"/3D/3dmodel.model\"/>", 1);
  EXPECT_THAT(refusal(file(), "a.3mf"),
              HasSubstr("a.3mf: 3D/Objects/part.model: <component objectid=\"1\">: it refers to "
                        "another file"));
  model.items = "<item objectid=\"1\" p:path=\"/3D/none.model\"/>";
  EXPECT_THAT(refusal(file(), "a.3mf"),
              HasSubstr("cannot read a.3mf: the archive has no file '3D/none.model'"));
}

TEST(ThreeMf, IsKnownByItsContentWhateverItsName) {
  EXPECT_EQ(refusal(file_of(cube_model().text()), "a.stl"), "nothing");
  EXPECT_THAT(refusal("solid", "a.3mf"), HasSubstr("the ZIP archive is cut off or damaged"));
  EXPECT_EQ(refusal("\x89PNG\r\n\x1A\n", "a.3mf"), "5 cannot read a.3mf: it is a PNG picture");
  EXPECT_EQ(refusal("", "a.3mf"), "5 cannot read a.3mf: it is empty");
  EXPECT_THAT(refusal(archive_of({{"a.txt", "a"}}), "a.3mf"),
              HasSubstr("it is a ZIP archive without a 3D model"));
  EXPECT_THAT(refusal(archive_of({{"_rels/.rels", "<Relationships/>"}}), "a.3mf"),
              HasSubstr("it is a ZIP archive without a 3D model"));
  EXPECT_THAT(refusal(archive_of({{"_rels/.rels", relations}}), "a.3mf"),
              HasSubstr("cannot read a.3mf: the archive has no file '3D/3dmodel.model'"));
}

// As other readers do: the checksums of the files in it show whether they are intact.
TEST(ThreeMf, MayHaveBytesAfterTheArchive) {
  EXPECT_EQ(refusal(file_of(cube_model().text()) + "more", "a.3mf"), "nothing");
}

TEST(ThreeMf, RefusesDamagedArchivesInOneLine) {
  const std::string whole = file_of(cube_model().text());
  for (std::size_t length = 0; length < whole.size(); ++length) {
    EXPECT_THAT(refusal(whole.substr(0, length), "a.3mf"),
                AllOf(StartsWith("5 cannot read a.3mf: "), Not(HasSubstr("\n"))));
  }
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x55);
    EXPECT_THAT(refusal(damaged, "a.3mf"),
                AnyOf("nothing", StartsWith("5 cannot read a.3mf: "), StartsWith("2 a.3mf: ")));
  }
  EXPECT_THAT(refusal(archive_of({{name_of_root, cube_model().text()}, {"_rels/.rels", relations}},
                                 encrypt),
                      "a.3mf"),
              HasSubstr("cannot read a.3mf: 3D/3dmodel.model: it is encrypted"));
  std::string damaged =
      archive_of({{name_of_root, cube_model().text()}, {"_rels/.rels", relations}}, store);
  damaged[damaged.find("<vertex x=\"0\"") + 11] = '7';
  EXPECT_THAT(refusal(damaged, "a.3mf"),
              HasSubstr("cannot read a.3mf: 3D/3dmodel.model: it cannot be unpacked"));
}

TEST(ThreeMf, RefusesDamagedModels) {
  const std::string whole = cube_model().text();
  for (std::size_t length = 0; length + 1 < whole.size(); length += 7) {
    EXPECT_THAT(refusal(file_of(whole.substr(0, length)), "a.3mf"),
                AllOf(StartsWith("5 cannot read a.3mf"), Not(HasSubstr("\n"))));
  }
  EXPECT_THAT(refusal(file_of("<svg/>"), "a.3mf"), HasSubstr("it is no model: its root is <svg>"));
  EXPECT_THAT(refusal(file_of("<model/>"), "a.3mf"),
              HasSubstr("a.3mf: 3D/3dmodel.model: there is nothing to build"));
}

TEST(ThreeMf, RefusesInvalidNumbers) {
  const auto with = [](const std::string& from, const std::string& to) {
    std::string text = cube_model().text();
    text.replace(text.find(from), from.size(), to);
    return refusal(file_of(text), "a.3mf");
  };
  EXPECT_THAT(with("<vertex x=\"0\"", "<vertex x=\"NaN\""),
              StartsWith("2 a.3mf: 3D/3dmodel.model: <object id=\"1\">: vertex 0: x has 'NaN', "
                         "which is no finite number"));
  EXPECT_THAT(with("<vertex x=\"0\"", "<vertex x=\"0,5\""), HasSubstr("vertex 0: x has '0,5'"));
  EXPECT_THAT(with("<vertex x=\"0\"", "<vertex x=\"1e999\""), HasSubstr("x has '1e999'"));
  EXPECT_THAT(with("<vertex x=\"0\"", "<vertex"), HasSubstr("vertex 0: x has ''"));
  EXPECT_THAT(
      with("v1=\"0\" v2=\"3\"", "v1=\"0\" v2=\"8\""),
      HasSubstr("triangle 0: it refers to vertex '8', but there are 8 vertices, from 0 on"));
  EXPECT_THAT(with("v1=\"0\"", "v1=\"-1\""), HasSubstr("refers to vertex '-1'"));
  EXPECT_THAT(with("v1=\"0\"", "v1=\"4294967296\""), HasSubstr("refers to vertex '4294967296'"));
  EXPECT_THAT(with("<item objectid=\"1\"", "<item objectid=\"2\""),
              HasSubstr("<item objectid=\"2\">: there is no object with this id in 3D/3dmodel"));
  EXPECT_THAT(with("<item ", "<item transform=\"1 2 3\" "), HasSubstr("its transform has no 12"));
  EXPECT_THAT(with("<item ", "<item transform=\"1 0 0 0 1 0 0 0 inf 0 0 0\" "),
              HasSubstr("its transform has 'inf', which is no finite number"));
  EXPECT_THAT(with("<item ", "<item transform=\"1e300 0 0 0 1 0 0 0 1 1e308 0 0\" "),
              HasSubstr("its integrals are beyond what double precision holds"));
  EXPECT_THAT(with("<item ", "<item transform=\"1e308 0 0 1e308 1 0 0 0 1 1e308 0 0\" "),
              HasSubstr("a node makes a coordinate infinite"));
  Model twice = cube_model();
  twice.objects += twice.objects;
  EXPECT_THAT(refusal_of(twice), HasSubstr("<object id=\"1\">: another object has the same id"));
  Model empty;
  empty.objects = "<object id=\"1\"/>";
  EXPECT_THAT(refusal_of(empty), HasSubstr("it has neither a mesh nor components"));
}

TEST(ThreeMf, BoundsItsWork) {
  Model model;
  model.objects = object_of("<component objectid=\"1\"/>", 1);
  EXPECT_THAT(refusal_of(model), HasSubstr("nested more than 1000 deep"));
  const auto doubled = [&](const std::string& last) {
    model.objects = last;
    for (int i = 1; i <= 40; ++i) {
      const std::string next = fmt::format("<component objectid=\"{}\"/>", i + 1);
      model.objects += object_of(next + next, i);
    }
    return refusal_of(model);
  };
  EXPECT_THAT(doubled(object_of("", 41)), HasSubstr("repeated more than 1000000 times"));
  EXPECT_THAT(doubled(object_of(cube({0, 0, 0}, 1.0), 41)),
              HasSubstr("repeated more than 1000000 times"));
  const std::string many = object_of(ball_with_open_poles(50, 50, 0.0), 41);
  EXPECT_THAT(doubled(many), HasSubstr("repeat its meshes to more than 8388608 triangles"));
  const auto refusal_of_part = [](const std::string& part) {
    const auto quickly = [](zip_t* archive) {
      zip_set_file_compression(archive, 0, ZIP_CM_DEFLATE, 1);
    };
    return refusal(archive_of({{name_of_root, part}, {"_rels/.rels", relations}}, quickly),
                   "a.3mf");
  };
  // They take 1 MB and 200 kB.
  EXPECT_THAT(refusal_of_part(std::string(300'000'000, ' ')),
              HasSubstr("cannot read a.3mf: its models have more than 268435456 bytes"));
  std::string elements;
  for (int i = 0; i <= 10'000'000; ++i) elements += "<a/>";
  EXPECT_THAT(refusal_of_part(elements),
              HasSubstr("cannot read a.3mf: 3D/3dmodel.model: it has more than 10000000 elements"));
}

// No entity is expanded.
TEST(ThreeMf, ExpandsNoEntities) {
  Model model = cube_model();
  std::string text = model.text();
  text.insert(text.find("<model"), "<!DOCTYPE x [<!ENTITY a \"0\">]>");
  EXPECT_EQ(refusal(file_of(text), "a.3mf"), "nothing");
  text.replace(text.find("x=\"0\""), 5, "x=\"&a;\"");
  EXPECT_THAT(refusal(file_of(text), "a.3mf"), HasSubstr("x has '&a;'"));
}

}  // namespace
}  // namespace twrench::mesh
