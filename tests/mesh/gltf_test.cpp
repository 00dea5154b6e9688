#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <vector>

#include "mesh/formats.h"
#include "mesh/refusal.h"
#include "mesh/samples.h"
#include "scratch_folder.h"
#include "system/bytes.h"
#include "system/file.h"

namespace twrench::mesh {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::FloatNear;
using testing::HasSubstr;
using testing::StartsWith;

/// Returns the positions of a cube from 0 to 1, its indices, and a linear colour per vertex.
std::string buffer() {
  const body::TriangleMesh mesh = cube({0, 0, 0}, 1);
  std::string bytes;
  for (const Eigen::Vector3d& v : mesh.vertices) {
    for (const double x : v) append(bytes, static_cast<float>(x));
  }
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) append(bytes, static_cast<std::uint16_t>(corner));
  }
  for (int i = 0; i < 8; ++i) {
    for (const int part : {255, 55, 0, 255}) append(bytes, static_cast<std::uint8_t>(part));
  }
  return bytes;
}

std::string data_uri(const std::string& bytes) {
  return "data:application/octet-stream;base64," +
         system::base64({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
}

json document() {
  json document = json::parse(R"({
    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
    "nodes": [{"mesh": 0}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "COLOR_0": 2}, "indices": 1,
                                "material": 0}]}],
    "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
    "textures": [{"source": 0}], "images": [{"uri": "../../../../etc/passwd"}],
    "accessors": [
      {"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3"},
      {"bufferView": 1, "componentType": 5123, "count": 36, "type": "SCALAR"},
      {"bufferView": 2, "componentType": 5121, "count": 8, "type": "VEC4", "normalized": true}],
    "bufferViews": [{"buffer": 0, "byteLength": 96}, {"buffer": 0, "byteOffset": 96, "byteLength": 72},
                    {"buffer": 0, "byteOffset": 168, "byteLength": 32, "byteStride": 4}],
    "buffers": [{"byteLength": 200}]})");
  document["buffers"][0]["uri"] = data_uri(buffer());
  return document;
}

std::string glb(json document) {
  document["buffers"][0].erase("uri");
  std::string text = document.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const std::string binary = buffer();
  std::string bytes = "glTF";
  append(bytes, std::uint32_t{2});
  append(bytes, static_cast<std::uint32_t>(12 + 8 + text.size() + 8 + binary.size()));
  append(bytes, static_cast<std::uint32_t>(text.size()));
  bytes += "JSON" + text;
  append(bytes, static_cast<std::uint32_t>(binary.size()));
  return bytes + std::string("BIN\0", 4) + binary;
}

MeshFile read_json(const json& document) { return read_mesh(document.dump(), "a.gltf", {}); }

TEST(Gltf, IsInMetres) {
  for (const std::string& bytes : {document().dump(), glb(document())}) {
    const MeshFile file = read_mesh(bytes, bytes[0] == '{' ? "a.gltf" : "a.glb", {});
    EXPECT_EQ(file.shape.integrals.volume, 1e6);
    EXPECT_EQ(file.shape.integrals.centroid, Eigen::Vector3d(50, 50, 50));
    EXPECT_EQ(read_mesh(bytes, "a.glTF", {.scale = 1.0}).shape.integrals.volume, 1);
  }
}

TEST(Gltf, MayHaveSignedBytesWithGapsBetweenThem) {
  std::string bytes;
  for (const Eigen::Vector3d& v : cube({0, 0, 0}, 1).vertices) {
    for (const double x : v) append(bytes, static_cast<std::int8_t>(x));
    append(bytes, std::int8_t{0});
  }
  json quantized = document();
  quantized["buffers"].push_back({{"byteLength", 32}, {"uri", data_uri(bytes)}});
  quantized["bufferViews"].push_back({{"buffer", 1}, {"byteLength", 32}, {"byteStride", 4}});
  quantized["accessors"][0] = {
      {"bufferView", 3}, {"componentType", 5120}, {"count", 8}, {"type", "VEC3"}};
  EXPECT_EQ(read_json(quantized).shape.integrals.volume, 1e6);
}

TEST(Gltf, HasTheColorsOfItsVertices) {
  const MeshFile file = read_json(document());
  ASSERT_EQ(file.shape.surface->colors.size(), 8U);
  // 55/255 of the light is 0.5 in sRGB.
  EXPECT_THAT(file.shape.surface->colors[5], ElementsAre(1.0F, FloatNear(0.502F, 0.002F), 0.0F));
}

TEST(Gltf, HasTheBaseColorsOfItsMaterials) {
  json painted = document();
  painted["materials"][0]["pbrMetallicRoughness"] = {
      {"baseColorFactor", {55.0 / 255.0, 1.0, 0.0, 1.0}}};
  EXPECT_THAT(read_json(painted).shape.surface->colors[5],
              ElementsAre(FloatNear(0.502F, 0.002F), FloatNear(0.502F, 0.002F), 0.0F))
      << "times that of the vertex";

  painted["meshes"][0]["primitives"][0]["attributes"].erase("COLOR_0");
  painted["meshes"].push_back(painted["meshes"][0]);
  painted["meshes"][1]["primitives"][0].erase("material");
  painted["nodes"].push_back({{"mesh", 1}, {"translation", {5, 0, 0}}});
  painted["scenes"][0]["nodes"] = {0, 1};
  const MeshFile file = read_json(painted);
  ASSERT_EQ(file.shape.surface->colors.size(), 16U);
  for (std::size_t i = 0; i < 16; ++i) {
    const bool is_painted = file.shape.surface->vertices[i].x() < 200;
    EXPECT_THAT(
        file.shape.surface->colors[i],
        ElementsAre(FloatNear(is_painted ? 0.502F : 1.0F, 0.002F), 1.0F, is_painted ? 0.0F : 1.0F));
  }

  painted["nodes"][0]["mesh"] = 1;
  EXPECT_EQ(read_json(painted).shape.surface->colors.size(), 0U);
}

TEST(Gltf, AppliesTheTransformsOfItsNodes) {
  json moved = document();
  moved["nodes"] =
      json::parse(R"([{"children": [1, 2], "translation": [10, 0, 0], "scale": [2, 2, 2]},
    {"mesh": 0, "rotation": [0, 0, 0.7071067811865476, 0.7071067811865476]},
    {"mesh": 0, "matrix": [-1,0,0,0, 0,1,0,0, 0,0,1,0, 5,0,0,1]}])");
  const MeshFile file = read_json(moved);
  EXPECT_EQ(file.components, 2U);
  EXPECT_EQ(file.notes.size(), 0U) << "a mirrored cube is not inside out";
  EXPECT_NEAR(file.shape.integrals.volume, 16e6, 1e-8);
  // The cubes' centres are (-0.5, 0.5, 0.5) and (4.5, 0.5, 0.5) in the frame of their parent.
  EXPECT_LE((file.shape.integrals.centroid - Eigen::Vector3d(1400, 100, 100)).norm(), 1e-10);
}

TEST(Gltf, WithoutASceneHasAllItsNodes) {
  json all = document();
  all.erase("scene"), all.erase("scenes");
  all["nodes"].push_back({{"mesh", 0}, {"translation", {5, 0, 0}}});
  EXPECT_EQ(read_json(all).components, 2U);
}

TEST(Gltf, ReadsStripsAndFansAndWhatHasNoIndices) {
  // A tetrahedron as a strip of four triangles and two more without area.
  json strip = document();
  std::string bytes;
  const std::array<std::array<float, 3>, 4> corners{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (const int i : {0, 2, 1, 3, 0, 2}) {
    for (const float x : corners[static_cast<std::size_t>(i)]) append(bytes, x);
  }
  strip["buffers"][0] = {{"byteLength", bytes.size()}, {"uri", data_uri(bytes)}};
  strip["bufferViews"] = {{{"buffer", 0}, {"byteLength", bytes.size()}}};
  strip["accessors"] = {
      {{"bufferView", 0}, {"componentType", 5126}, {"count", 6}, {"type", "VEC3"}}};
  strip["meshes"][0]["primitives"] = {{{"attributes", {{"POSITION", 0}}}, {"mode", 5}}};
  EXPECT_NEAR(read_json(strip).shape.integrals.volume, 1e6 / 6, 1e-9);
  strip["meshes"][0]["primitives"][0]["mode"] = 6;
  EXPECT_THAT(refusal(strip.dump(), "a.gltf"), HasSubstr("open at")) << "a fan";
  strip["meshes"][0]["primitives"][0]["mode"] = 1;
  EXPECT_THAT(refusal(strip.dump(), "a.gltf"), HasSubstr("no triangles")) << "lines";
  strip["meshes"][0]["primitives"][0]["mode"] = 7;
  EXPECT_THAT(refusal(strip.dump(), "a.gltf"), HasSubstr("is no kind of primitive"));
}

TEST(Gltf, ReadsBuffersBesideIt) {
  const ScratchFolder folder;
  json other = document();
  other["buffers"][0]["uri"] = "a%20b.bin";
  system::write_file_atomically(folder / "a.gltf", other.dump());
  EXPECT_THROW(read_mesh(folder / "a.gltf", {}), system::FileError) << "it is missing";
  system::write_file_atomically(folder / "a b.bin", buffer());
  const MeshFile file = read_mesh(folder / "a.gltf", {});
  EXPECT_EQ(file.shape.integrals.volume, 1e6);
  system::write_file_atomically(folder / "a b.bin", buffer() + "x");
  EXPECT_NE(read_mesh(folder / "a.gltf", {}).sha256, file.sha256) << "it is part of the mesh";
}

TEST(Gltf, ReadsABufferOnceHoweverOftenItIsNamed) {
  const ScratchFolder folder;
  json other = document();
  other["buffers"] = {{{"byteLength", 200}, {"uri", "./a.bin"}},
                      {{"byteLength", 200}, {"uri", "a.bin"}},
                      {{"byteLength", 200}, {"uri", "././%61.bin"}}};
  for (std::size_t i = 0; i < 3; ++i) other["bufferViews"][i]["buffer"] = i;
  system::write_file_atomically(folder / "a.gltf", other.dump());
  system::write_file_atomically(folder / "a.bin", buffer());
  const MeshFile file = read_mesh(folder / "a.gltf", {});
  EXPECT_EQ(file.shape.integrals.volume, 1e6);
  EXPECT_THAT(file.others, ElementsAre(folder / "a.bin"));
}

// Repeated meshes are counted before they are built. Building the first one would take minutes and
// gigabytes.
TEST(Gltf, RefusesFarMoreTrianglesThanTheFileHasBytes) {
  json other = document();
  const json primitive = other["meshes"][0]["primitives"][0];
  for (int i = 1; i < 1000; ++i) other["meshes"][0]["primitives"].push_back(primitive);
  for (int i = 1; i < 1000; ++i) {
    other["nodes"].push_back({{"mesh", 0}, {"translation", {3 * i, 0, 0}}});
    other["scenes"][0]["nodes"].push_back(i);
  }
  EXPECT_EQ(refusal(other.dump(), "a.gltf"),
            "2 a.gltf: its nodes repeat its meshes to more than 3000000 triangles, or 9000000 "
            "vertices");
  for (json& each : other["meshes"][0]["primitives"]) each["mode"] = 1;
  EXPECT_THAT(refusal(other.dump(), "a.gltf"), HasSubstr("no triangles"))
      << "a million primitives of lines are not visited one by one";
  other["meshes"][0]["primitives"] = {primitive};
  EXPECT_EQ(read_json(other).shape.surface->triangles.size(), 12'000U);
}

TEST(Gltf, OpensNothingElsewhere) {
  const ScratchFolder folder;
  system::write_file_atomically(folder / "a.bin", buffer());
  std::filesystem::create_directory(folder / "b");
  for (const std::string& uri :
       {std::string("../a.bin"), std::string("%2e%2e/a.bin"), (folder / "a.bin").string(),
        "file://" + (folder / "a.bin").string(), std::string(".."), std::string(""),
        std::string("http://localhost/a.bin"), std::string("..\\a.bin")}) {
    json other = document();
    other["buffers"][0]["uri"] = uri;
    system::write_file_atomically(folder / "b/a.gltf", other.dump());
    try {
      read_mesh(folder / "b/a.gltf", {});
      FAIL() << uri;
    } catch (const InvalidArgument& error) {
      EXPECT_THAT(error.what(), HasSubstr("its buffers[0].uri refers to")) << uri;
    }
    EXPECT_THAT(refusal(other.dump(), "a.gltf"), StartsWith("2 a.gltf: its buffers[0].uri"));
  }
}

/// Returns the document with the value at a JSON pointer changed.
std::string with(const std::string& pointer, const json& value) {
  json changed = document();
  changed[json::json_pointer(pointer)] = value;
  return changed.dump();
}

TEST(Gltf, ThatIsBadIsRefusedWithThePlace) {
  EXPECT_EQ(refusal(with("/scene", 0), "a.gltf"), "nothing");
  const std::string cannot = "5 cannot read a.gltf: its ";
  for (const auto& [pointer, value, message] : {
           std::tuple("/asset/version", json("1.0"), cannot + "asset.version is not 2.0"),
           {"/asset", json(), cannot + "asset is no object"},
           {"/scene", json(1), cannot + "scenes has 1 entries, but 1 is referred to"},
           {"/scene", json(-1), cannot + "scene is no whole number"},
           {"/nodes/0/mesh", json(7), cannot + "meshes has 1 entries"},
           {"/nodes/0/children", json::array({0}),
            cannot + "nodes[0] is a child of more than one node"},
           {"/nodes/0/matrix", json({1, 2}), cannot + "nodes[0].matrix must have 16 numbers"},
           {"/nodes/0/translation", json({1, 2, "x"}),
            cannot + "nodes[0].translation[2] is no number"},
           {"/nodes/0/scale", json({1e300, 1e300, 1e300}), "2 a.gltf: its integrals are beyond"},
           {"/accessors/0/count", json(9), cannot + "accessors[0] goes beyond the 96 bytes"},
           {"/accessors/0/count", json(18446744073709551615U), cannot + "accessors[0] goes beyond"},
           {"/accessors/0/byteOffset", json(4), cannot + "accessors[0] goes beyond"},
           {"/accessors/0/type", json("VEC2"), cannot + "accessors[0] has too few components"},
           {"/accessors/0/type", json("VEC9"), cannot + "accessors[0].type is no type"},
           {"/accessors/0/componentType", json(5130), cannot + "accessors[0].componentType is no"},
           {"/accessors/1/componentType", json(5122),
            cannot + "meshes[0].primitives[0].indices are no"},
           {"/accessors/0/sparse", json::object(), cannot + "accessors[0].sparse has no 'indices'"},
           {"/bufferViews/0/byteLength", json(201), cannot + "bufferViews[0] goes beyond the 200"},
           {"/bufferViews/1/byteLength", json(105), cannot + "bufferViews[1] goes beyond the 200"},
           {"/bufferViews/0/byteOffset", json(18446744073709551615U),
            cannot + "bufferViews[0] goes"},
           {"/bufferViews/0/byteStride", json(0), cannot + "bufferViews[0].byteStride is no"},
           {"/buffers/0/byteLength", json(4294967296),
            cannot + "buffers[0] is cut off: it has 200"},
           {"/buffers/0/uri", json("data:;base64,####"), cannot + "buffers[0].uri is no data"},
       }) {
    EXPECT_THAT(refusal(with(pointer, value), "a.gltf"), StartsWith(message)) << pointer;
  }
  EXPECT_EQ(refusal("{\"asset\": ", "a.gltf"),
            "5 cannot read a.gltf: it is no glTF: no JSON at byte 11");
  EXPECT_THAT(refusal("[1e999]", "a.gltf"), HasSubstr("a number is too large"));
  EXPECT_THAT(refusal("[]", "a.gltf"), HasSubstr("its JSON is no object"));
}

/// Returns the remedy for a file that requires the extension; empty if it is read.
std::string remedy_for_required(const std::string& extension) {
  json required = document();
  required["extensionsRequired"] = {extension};
  try {
    read_json(required);
  } catch (const InvalidArgument& error) {
    EXPECT_THAT(error.what(), HasSubstr("it needs the extension '" + extension + "'"));
    return error.remedy();
  }
  return "";
}

TEST(Gltf, ThatNeedsAnExtensionHasTheRemedyForIt) {
  for (const auto& [extension, remedy] :
       {std::pair("KHR_draco_mesh_compression", "save it without compression"),
        {"EXT_meshopt_compression", "save it without compression"},
        {"EXT_mesh_gpu_instancing", "save it with a node for each instance"},
        {"KHR_animation_pointer", "save it without this extension"},
        {"VENDOR_unknown", "save it without this extension"},
        {"KHR_texture_basisu", ""},
        {"KHR_texture_transform", ""},
        {"EXT_texture_webp", ""},
        {"KHR_materials_unlit", ""},
        {"KHR_mesh_quantization", ""}}) {
    EXPECT_EQ(remedy_for_required(extension), remedy) << extension;
  }
}

TEST(Gltf, MayBeginWithAByteOrderMark) {
  EXPECT_EQ(read_mesh("\xEF\xBB\xBF" + document().dump(), "a.gltf", {}).shape.integrals.volume,
            1e6);
}

/// Returns a document with a sparse accessor for the positions. Vertices 1 and 6 are replaced by
/// those of a cube; the buffer view, if there is one, has the others.
json sparse_document(bool has_base, const std::vector<std::uint8_t>& indices) {
  const std::vector<Eigen::Vector3d> vertices = cube({0, 0, 0}, 1).vertices;
  std::string values;
  for (const std::uint8_t index : indices) {
    for (const double x : vertices[index % 8]) append(values, static_cast<float>(x));
  }
  const std::string list(indices.begin(), indices.end());
  json sparse = document();
  std::string base = buffer();
  for (const std::size_t index : {1U, 6U}) base.replace(12 * index, 12, 12, '\x41');
  sparse["buffers"] = {{{"byteLength", 200}, {"uri", data_uri(base)}},
                       {{"byteLength", values.size()}, {"uri", data_uri(values)}},
                       {{"byteLength", list.size()}, {"uri", data_uri(list)}}};
  sparse["bufferViews"].push_back({{"buffer", 1}, {"byteLength", values.size()}});
  sparse["bufferViews"].push_back({{"buffer", 2}, {"byteLength", list.size()}});
  if (!has_base) sparse["accessors"][0].erase("bufferView");
  sparse["accessors"][0]["sparse"] = {{"count", indices.size()},
                                      {"indices", {{"bufferView", 4}, {"componentType", 5121}}},
                                      {"values", {{"bufferView", 3}}}};
  return sparse;
}

TEST(Gltf, ReadsSparseAccessors) {
  EXPECT_EQ(read_json(sparse_document(true, {1, 6})).shape.integrals.volume, 1e6);
  EXPECT_EQ(read_json(sparse_document(false, {0, 1, 2, 3, 4, 5, 6, 7})).shape.integrals.volume,
            1e6);
  EXPECT_EQ(read_json(sparse_document(false, {1, 2, 3, 4, 5, 6, 7})).shape.integrals.volume, 1e6)
      << "elements that are not replaced are 0";
}

TEST(Gltf, OfABadSparseAccessorIsRefused) {
  const std::string cannot = "5 cannot read a.gltf: its accessors[0].sparse";
  EXPECT_EQ(refusal(sparse_document(true, {1, 14}).dump(), "a.gltf"),
            cannot + ".indices refers to element 14, but there are 8, from 0 on");
  for (const auto& indices : {std::vector<std::uint8_t>{6, 1}, {1, 1, 6}}) {
    EXPECT_EQ(refusal(sparse_document(true, indices).dump(), "a.gltf"),
              cannot + ".indices is not in order");
  }
  json other = sparse_document(true, {1, 6});
  other["accessors"][0]["sparse"]["count"] = 3;
  EXPECT_EQ(refusal(other.dump(), "a.gltf"),
            cannot + ".indices goes beyond the 2 bytes of its buffer view");
  other["accessors"][0]["sparse"]["count"] = 2;
  other["accessors"][0]["sparse"]["values"]["byteOffset"] = 4;
  EXPECT_EQ(refusal(other.dump(), "a.gltf"),
            cannot + ".values goes beyond the 24 bytes of its buffer view");
  other["accessors"][0]["sparse"]["indices"]["componentType"] = 5120;
  EXPECT_THAT(refusal(other.dump(), "a.gltf"), StartsWith(cannot));
}

TEST(Gltf, OfAVertexThatIsNotThereIsRefused) {
  std::string bytes = buffer();
  bytes.replace(96, 2, "\x08\0", 2);
  EXPECT_EQ(
      refusal(with("/buffers/0/uri", data_uri(bytes)), "a.gltf"),
      "2 a.gltf: meshes[0].primitives[0].indices, element 0: it refers to vertex 8, but there "
      "are 8 vertices, from 0 on");
  bytes = buffer();
  bytes.replace(12, 4, "\0\0\xc0\x7f", 4);
  EXPECT_EQ(
      refusal(with("/buffers/0/uri", data_uri(bytes)), "a.gltf"),
      "2 a.gltf: meshes[0].primitives[0].attributes.POSITION, element 1: a coordinate is not a "
      "finite number");
}

TEST(Gltf, ThatIsCutOffIsRefused) {
  const std::string whole = glb(document());
  EXPECT_EQ(refusal(whole, "a.glb"), "nothing");
  for (std::size_t size = 4; size < whole.size(); ++size) {
    EXPECT_THAT(refusal(whole.substr(0, size), "a.glb"), HasSubstr("is cut off")) << size;
  }
  std::string long_chunk = whole;
  long_chunk.replace(12, 4, "\xff\xff\xff\xff");
  EXPECT_THAT(refusal(long_chunk, "a.glb"), HasSubstr("a chunk goes beyond its end"));
}

TEST(Gltf, SaysWhatIsLeftOut) {
  json other = document();
  other["skins"] = {json::object()};
  other["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", 0}}}, {"mode", 0}});
  EXPECT_THAT(read_json(other).notes,
              ElementsAre(HasSubstr("points or lines"), HasSubstr("skins")));
  json repeated = document();
  repeated["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"] = {{"attributes", json::object()}};
  EXPECT_THAT(read_json(repeated).notes,
              ElementsAre("the instances of its nodes (EXT_mesh_gpu_instancing) are left out"));
}

}  // namespace
}  // namespace twrench::mesh
