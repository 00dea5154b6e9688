#include "page/page_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <twrench/base/error.h>
#include <zlib.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <glm/geometric.hpp>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "base/enumeration.h"
#include "page/packing.h"
#include "page/recording_json.h"
#include "picture/body/meshes.h"
#include "picture/look/theme.h"
#include "sanitizers.h"
#include "system/bytes.h"

namespace twrench::page {
namespace {

using Eigen::Vector3d;
using nlohmann::ordered_json;

std::vector<std::uint8_t> inflated(const std::vector<std::uint8_t>& bytes) {
  std::vector<std::uint8_t> result(std::size_t{1} << 22U);
  uLongf size = result.size();
  EXPECT_EQ(uncompress(result.data(), &size, bytes.data(), bytes.size()), Z_OK);
  result.resize(size);
  return result;
}

/// Unpacks integers in rows of the given width, on a little-endian processor.
template <typename Integer>
std::vector<Integer> unpacked(const std::string& text, std::size_t width) {
  const std::vector<std::uint8_t> bytes = inflated(system::bytes_of_base64(text).value());
  std::vector<Integer> integers(bytes.size() / sizeof(Integer));
  if (!integers.empty()) std::memcpy(integers.data(), bytes.data(), bytes.size());
  for (std::size_t i = width; i < integers.size(); ++i) {
    integers[i] = static_cast<Integer>(integers[i] + integers[i - width]);
  }
  return integers;
}

ordered_json json_of(const scene::Scene& scene) { return page_json(scene, surface_of(scene.body)); }

/// The volume in cm^3 that the surface encloses, positive if its triangles face outwards.
double volume_within(const ordered_json& surface) {
  const auto vertices = unpacked<std::int16_t>(surface.at("vertices"), 6);
  const auto indices = unpacked<std::uint32_t>(surface.at("indices"), 1);
  const double unit = surface.at("radius").get<double>() / 32767;
  const auto vector = [&](std::size_t at) {
    return Vector3d(vertices.at(at), vertices.at(at + 1), vertices.at(at + 2));
  };
  double volume = 0;
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    std::array<Vector3d, 3> corner;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t vertex = 6 * std::size_t{indices[i + k]};
      corner[k] = unit * vector(vertex);
      EXPECT_NEAR(vector(vertex + 3).norm() / 32767, 1, 1e-4);
    }
    volume += corner[0].dot(corner[1].cross(corner[2])) / 6;
  }
  return volume;
}

TEST(PageJson, ContainsTheSurfaceOfTheBody) {
  const ordered_json surface = json_of(scene::load_scene("sphere")).at("surface");
  EXPECT_DOUBLE_EQ(surface.at("radius"), 1);
  EXPECT_NEAR(volume_within(surface), 4 * std::numbers::pi / 3, 0.01);
  EXPECT_EQ(surface.at("mark").size(), 12U);
  ASSERT_EQ(surface.at("parts").size(), 1U);
  EXPECT_EQ(surface["parts"][0]["end"], unpacked<std::uint32_t>(surface.at("indices"), 1).size());
}

TEST(PageJson, PacksIntegersOfAnySize) {
  const std::vector<std::uint16_t> narrow{0, 65535, 1, 32768, 65535, 0, 7};
  EXPECT_EQ(unpacked<std::uint16_t>(packed(narrow, 3), 3), narrow);
  const std::vector<std::uint32_t> wide{70'000, 0, 4'294'967'295, 1};
  EXPECT_EQ(unpacked<std::uint32_t>(packed(wide, 1), 1), wide);
  EXPECT_EQ(unpacked<std::uint32_t>(packed(std::vector<std::uint32_t>(), 1), 1).size(), 0U);
}

/// The attitudes of a body that turns by a tenth of a radian in each step, and wobbles.
scene::ShownRecording recording_of(std::size_t rows) {
  std::vector<motion::RecordedMotion::Instant> instants;
  for (std::size_t i = 0; i < rows; ++i) {
    const double t = 0.02 * double(i), angle = 5 * t;
    const Eigen::Quaterniond X(Eigen::AngleAxisd(angle, Vector3d::UnitY()) *
                               Eigen::AngleAxisd(0.1, Vector3d::UnitX()));
    instants.push_back({t, X, Eigen::AngleAxisd(-0.1, Vector3d::UnitX()) * Vector3d(0, 5, 0)});
  }
  return {.file = "logs/toss.csv",
          .path = {},
          .motion = {std::move(instants), 0.08},
          .flip_times = {0.5},
          .sha256 = {}};
}

TEST(PageJson, ContainsEveryRowOfARecording) {
  const scene::ShownRecording recording = recording_of(300);
  const PageRecording shown = page_recording(recording);
  EXPECT_EQ(shown.note, "");
  const ordered_json json = recording_json(recording, shown.motion);
  EXPECT_EQ(json.at("file"), "toss.csv");
  EXPECT_EQ(json.at("flips"), nlohmann::json({0.5}));
  const auto halves = unpacked<std::uint32_t>(json.at("rows"), 16);
  std::vector<double> rows(halves.size() / 2);
  std::memcpy(rows.data(), halves.data(), 4 * halves.size());
  ASSERT_EQ(rows.size(), 8U * 300);
  for (std::size_t i = 0; i < 300; ++i) {
    const auto& [t, X, omega] = recording.motion.instants()[i];
    const std::array ought{t, X.w(), X.x(), X.y(), X.z(), omega.x(), omega.y(), omega.z()};
    EXPECT_TRUE(std::ranges::equal(ought, std::span(rows).subspan(8 * i, 8))) << i;
  }
}

TEST(PageJson, HasFewerRowsOfALongRecordingAndStatesTheAngle) {
  const scene::ShownRecording recording = recording_of(20'000);
  const PageRecording shown = page_recording(recording);
  EXPECT_LE(shown.motion.instants().size(), 5000U);
  EXPECT_LT(recording_json(recording, shown.motion).dump().size(), 450'000U);
  EXPECT_THAT(shown.note, testing::HasSubstr("of the 20000 rows of logs/toss.csv; at the others "
                                             "the attitude differs by at most "));
}

/// Rows whose attitudes are not connected by any motion.
TEST(PageJson, RefusesARecordingThatFewRowsCannotShow) {
  std::vector<motion::RecordedMotion::Instant> instants;
  for (int i = 0; i < 6000; ++i) {
    const double angle = i % 3;
    instants.push_back(
        {0.02 * i, Eigen::Quaterniond(Eigen::AngleAxisd(angle, Vector3d::UnitX())), {1, 2, 3}});
  }
  const scene::ShownRecording recording{.file = "noise.csv",
                                        .path = {},
                                        .motion = {std::move(instants), 1},
                                        .flip_times = {},
                                        .sha256 = {}};
  EXPECT_THROW(page_recording(recording), InvalidArgument);
}

TEST(PageJson, ListsThePartsThatTouch) {
  const ordered_json surface = json_of(scene::load_scene("dzhanibekov")).at("surface");
  const ordered_json &leg = surface.at("parts").at(1), &model = surface.at("model");
  EXPECT_EQ(surface.at("occluder_count"), 1);
  // After the radius and the number of parts: 15 numbers of a part and the number of its occluders,
  // with 9 numbers each; the last but one states whether the occluder meets the part.
  const std::size_t part = 16, of_leg = 2 + part + 9 * model.at(2 + 15).get<std::size_t>();
  ASSERT_EQ(model.at(of_leg + 15), 1);
  EXPECT_EQ(model.at(of_leg + part + 7), 1);
  EXPECT_LT(leg.at("side_begin"), leg.at("end"));
  EXPECT_FALSE(surface.contains("mark"));
}

TEST(PageJson, ListsThePartsThatAreFoil) {
  const ordered_json book = json_of(scene::load_scene("book")).at("surface").at("model");
  const ordered_json wrench = json_of(scene::load_scene("dzhanibekov")).at("surface").at("model");
  const std::size_t foil = 2 + 14, part = 16;  // the book has no occluders
  EXPECT_EQ(book.at(foil), 0);
  EXPECT_EQ(book.at(part + foil), 1) << "the print";
  EXPECT_EQ(wrench.at(foil), 0);
}

TEST(PageJson, KeepsThePageSmall) {
  if (has_sanitizers) GTEST_SKIP() << "tests the sizes of pages that others write";
  for (const std::string& name : scene::builtin_scene_names()) {
    const ordered_json surface = json_of(scene::load_scene(name)).at("surface");
    // The rest of a page takes 330 kB.
    EXPECT_LT(surface.dump().size(), name == "dzhanibekov" ? 20'000U : 150'000U) << name;
  }
}

/// A scene with a wavy ball of the given number of meridians; a thin wall if `shell` > 0.
scene::Scene ball(int meridians, double shell, double wave) {
  body::TriangleMesh mesh = picture::ball_of_triangles(3, meridians);
  for (Vector3d& place : mesh.vertices) place *= 1 + wave * std::sin(9 * place.x());
  mesh.colors.assign(mesh.vertices.size(), {1, 0, 0});
  scene::Scene scene = scene::load_scene("dzhanibekov");
  scene.body.parts = {picture::part_of(std::move(mesh))};
  if (shell > 0) std::get<body::Mesh>(scene.body.parts[0].shape).shell = shell;
  scene.body.descriptions.clear();
  return scene;
}

TEST(PageJson, DrawsALargeMeshByFewerTriangles) {
  if (has_sanitizers) GTEST_SKIP() << "takes long for large meshes";
  const scene::Scene scene = ball(200, 0, 0.05);
  const Surface surface = surface_of(scene.body);
  ASSERT_TRUE(surface.simplification);
  EXPECT_EQ(surface.simplification->given, 4U * 199 * 200);
  EXPECT_LE(surface.simplification->drawn, 20'000U);
  EXPECT_GT(surface.simplification->drawn, 15'000U);
  const ordered_json json = page_json(scene, surface);
  const double volume = body::volume(scene.body.parts[0].shape);
  EXPECT_NEAR(volume_within(json.at("surface")), volume, 3e-3 * volume);
  EXPECT_EQ(json["surface"]["parts"][0]["tint"], nlohmann::json({1, 0, 0}));
  EXPECT_EQ(surface.mesh.colors.size(), surface.mesh.vertices.size());
  EXPECT_FALSE(surface_of(ball(40, 0, 0.05).body).simplification);
}

TEST(PageJson, DrawsBothSidesOfALargeWall) {
  if (has_sanitizers) GTEST_SKIP() << "takes long for large meshes";
  const Surface surface = surface_of(ball(200, 0.01, 0.05).body);
  double outwards = 0;
  for (const picture::Vertex& vertex : surface.mesh.vertices) {
    outwards += glm::dot(vertex.normal, vertex.position) > 0 ? 1 : -1;
  }
  EXPECT_NEAR(outwards, 0, 0.02 * static_cast<double>(surface.mesh.vertices.size()));
  EXPECT_LE(surface.simplification->drawn, 20'000U);
}

TEST(PageJson, DrawsALargeRoughMeshByFewerTriangles) {
  scene::Scene scene = ball(200, 0, 0);
  body::TriangleMesh rough = *std::get<body::Mesh>(scene.body.parts[0].shape).surface;
  unsigned state = 1;
  for (Vector3d& place : rough.vertices) {
    state = state * 1'103'515'245U + 12'345U;
    place *= 1 + 0.03 * (state >> 16U & 0xFFU) / 255;
  }
  scene.body.parts = {picture::part_of(std::move(rough))};
  const Surface surface = surface_of(scene.body);
  EXPECT_LE(surface.simplification->drawn, 40'000U);
  EXPECT_LT(surface.mesh.vertices.size(), 40'000U);
}

TEST(PageJson, KeepsASmallMeshBesideALargeOne) {
  scene::Scene scene = ball(200, 0, 0.05);
  scene.body.parts.push_back(picture::part_of(picture::box_of_triangles({1, 1, 1})));
  const Surface surface = surface_of(scene.body);
  ASSERT_EQ(surface.mesh.part_ends.size(), 2U);
  EXPECT_EQ(surface.mesh.part_ends[1] - surface.mesh.part_ends[0], 36U);
}

TEST(PageJson, CountsTheTrianglesOfAllMeshesTogether) {
  if (has_sanitizers) GTEST_SKIP() << "takes long for large meshes";
  scene::Scene scene = ball(40, 0, 0.05);
  scene.body.parts.push_back(scene.body.parts[0]);
  EXPECT_FALSE(surface_of(scene.body).simplification) << "12,480 triangles are few enough";
  scene = ball(100, 0, 0.05);
  scene.body.parts.push_back(scene.body.parts[0]);
  const Surface surface = surface_of(scene.body);
  ASSERT_TRUE(surface.simplification);
  EXPECT_EQ(surface.simplification->given, 2U * 4 * 99 * 100);
  EXPECT_EQ(surface.simplification->drawn, surface.mesh.indices.size() / 3);
  EXPECT_GT(surface.simplification->drawn, 15'000U);
}

TEST(PageJson, ContainsTheInertiaRowByRow) {
  const scene::Scene scene = scene::load_scene("dzhanibekov");
  const Eigen::Matrix3d inertia = scene::mass_properties(scene.body).inertia;
  const auto numbers = json_of(scene).at("inertia").get<std::vector<double>>();
  ASSERT_EQ(numbers.size(), 9U);
  for (Eigen::Index row = 0; row < 3; ++row) {
    for (Eigen::Index column = 0; column < 3; ++column) {
      EXPECT_EQ(numbers[static_cast<std::size_t>(3 * row + column)], inertia(row, column));
    }
  }
}

bool has_floor(const std::string& theme) {
  return picture::style_of(find_enumerator<scene::Theme>(theme, "theme")).floor.has_value();
}

TEST(PageJson, GivesEachThemeTheLookOfTheScene) {
  scene::Scene scene = scene::load_scene("dzhanibekov");
  for (const double metallic : {0.0, 1.0}) {
    scene.look.metallic = metallic;
    const ordered_json themes = json_of(scene).at("themes");
    EXPECT_EQ(themes.size(), enumerators<scene::Theme>.size());
    for (const auto& [name, theme] : themes.items()) {
      const ordered_json& material = theme.at("materials").at(0);
      EXPECT_EQ(material.at("metal"), metallic == 1);
      EXPECT_NE(material.at("constants").get<std::string>().find("light_radiance"),
                std::string::npos);
      EXPECT_EQ(theme.at("floor").is_null(), !has_floor(name));
      EXPECT_EQ(theme.at("overlay").at("curve").size(), 9U);
    }
  }
}

TEST(PageWords, NameEachThemeInEachLanguage) {
  for (const char* const language : {"en", "nb"}) {
    const std::string file = std::string(TWRENCH_TESTS_DIR "/../web/words/") + language + ".json";
    const ordered_json words = ordered_json::parse(std::ifstream(file));
    for (const std::string& theme : enumerator_names<scene::Theme>()) {
      EXPECT_TRUE(words.contains("theme_" + theme)) << theme << " in " << file;
    }
  }
}

TEST(PageTemplate, HasAFigureAndWordsForEachInset) {
  const std::string web = TWRENCH_TESTS_DIR "/../web/";
  std::ifstream file(web + "index.html");
  const std::string html(std::istreambuf_iterator<char>(file), {});
  for (const auto& [view, feature] : scene::insets) {
    const std::string name(enumerator_name(feature));
    EXPECT_NE(html.find("id=\"" + name + "\" class=\"view\""), std::string::npos) << name;
    for (const char* const language : {"en.json", "nb.json"}) {
      const ordered_json words = ordered_json::parse(std::ifstream(web + "words/" + language));
      for (const char* const kind : {"Keys", "Name", "Says"}) {
        EXPECT_TRUE(words.contains(name + kind)) << name << kind << " in " << language;
        EXPECT_NE(html.find('"' + name + kind + '"'), std::string::npos) << name << kind;
      }
    }
  }
}

TEST(PageJson, ContainsTheInteriorOfTheBody) {
  scene::Scene scene = scene::load_scene("dzhanibekov");
  EXPECT_FALSE(json_of(scene).at("scene").at("motion").contains("wheel"));
  scene.motion.wheel = Vector3d(1, 2, 3);
  scene.motion.energy_loss_time = 50;
  const ordered_json json = json_of(scene), &motion = json.at("scene").at("motion");
  EXPECT_EQ(motion.at("wheel"), ordered_json({1.0, 2.0, 3.0}));
  EXPECT_EQ(motion.at("energy_loss_time"), 50);
  EXPECT_EQ(json.at("limits").at("energy_loss_time"), ordered_json({1e-15, 1e15}));
  // An inset or an overlay that the page would offer, but the film refuses.
  for (const char* const feature : {"plane", "poinsot"}) {
    EXPECT_NE(json.at("rigid_features").dump().find(feature), std::string::npos) << feature;
  }
  EXPECT_EQ(json.at("lossless_features"), ordered_json({"drift"}));
}

TEST(PageJson, LeavesOutTheShotsOfAStory) {
  const scene::Scene story = scene::load_scene("explain");
  ASSERT_FALSE(story.shots.empty());
  EXPECT_FALSE(json_of(story).at("scene").contains("shot"));
}

}  // namespace
}  // namespace twrench::page
