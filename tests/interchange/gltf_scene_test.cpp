#include "interchange/gltf_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <twrench/motion/exact.h>
#include <twrench/motion/rotating_frame.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <random>

#include "interchange/glb_reader.h"
#include "interchange/playback.h"
#include "picture/look/material.h"

namespace twrench::interchange {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using testing::ElementsAre;

GlbReader read(const scene::Scene& scene, const AnimationOptions& options = {}) {
  return GlbReader(glb_of(gltf_scene(scene, options, "twrench")));
}

motion::ExactMotion exact_motion(const scene::Scene& scene) {
  return motion::ExactMotion(
      motion::FreeBody(scene::mass_properties(scene.body).inertia, scene.motion.omega));
}

std::vector<std::string> names_of(const nlohmann::json& nodes) {
  std::vector<std::string> names;
  for (const auto& node : nodes) names.push_back(node["name"]);
  return names;
}

std::vector<float> numbers(const GlbReader& glb, const nlohmann::json& sampler, const char* of) {
  return glb.floats(sampler[of].get<std::size_t>());
}

// Reads the file as a program does that knows only glTF: at random times, the motion is within the
// bound.
TEST(GltfScene, PlaysTheExactMotion) {
  const scene::Scene scene = scene::load_scene("dzhanibekov");
  const motion::ExactMotion exact = exact_motion(scene);
  const GlbReader glb = read(scene);
  const auto body = glb.sampler("body", "rotation"), arrow = glb.sampler("omega", "rotation"),
             scale = glb.sampler("omega", "scale");
  EXPECT_EQ(body["interpolation"], "LINEAR");
  const auto times = numbers(glb, body, "input"), keys = numbers(glb, body, "output"),
             arrow_times = numbers(glb, arrow, "input"), turns = numbers(glb, arrow, "output"),
             scales = numbers(glb, scale, "output");
  EXPECT_LT(times.size(), 1250U);
  EXPECT_EQ(times.back(), 96);
  std::mt19937_64 random(2026);
  std::uniform_real_distribution<double> instant(0, 96);
  double worst = 0;
  for (int i = 0; i < 1000; ++i) {
    const double t = instant(random);
    const motion::Sample sample = exact.at(t);
    worst = std::max(worst, angle_between(played_rotation(times, keys, t), sample.X));
    EXPECT_LE(angle_between(played_rotation(arrow_times, turns, t) * Vector3d::UnitZ(),
                            sample.X * sample.omega),
              1e-4);
    const auto [key, share] = between(arrow_times, t);
    const double length = (1 - share) * scales[3 * key] + share * scales[3 * key + 3];
    EXPECT_NEAR(length * scene.motion.omega.norm() / sample.omega.norm(), 1, 1e-4);
  }
  EXPECT_LE(worst, 1e-4);
  EXPECT_GT(worst, 0.5e-4);
}

TEST(GltfScene, PlaysFasterIfAsked) {
  const scene::Scene scene = scene::load_scene("dzhanibekov");
  const GlbReader glb = read(scene, {.speed = 6});
  const auto body = glb.sampler("body", "rotation");
  const auto times = numbers(glb, body, "input"), keys = numbers(glb, body, "output");
  EXPECT_EQ(times.back(), 16);
  EXPECT_LE(angle_between(played_rotation(times, keys, 7.3), exact_motion(scene).at(6 * 7.3).X),
            1e-4);
}

TEST(GltfScene, IsTheBodyWithItsAxesTheArrowsAndTheCamera) {
  const GlbReader glb = read(scene::load_scene("dzhanibekov"));
  EXPECT_THAT(names_of(glb.json["nodes"]),
              ElementsAre("camera", "handle", "leg", "x", "y", "z", "body", "L", "omega"));
  EXPECT_THAT(glb.json["nodes"][6]["children"], ElementsAre(1, 2, 3, 4, 5));
  EXPECT_THAT(glb.json["scenes"][0]["nodes"], ElementsAre(0, 6, 7, 8));
  EXPECT_FALSE(glb.json.contains("extensionsUsed"));
}

// Parts that look the same share a material.
TEST(GltfScene, HasAMaterialForEachLookOfAPart) {
  scene::Scene scene = scene::load_scene("dzhanibekov");
  scene.body.parts.push_back(scene.body.parts.back());
  scene.body.descriptions.resize(3);
  scene.body.descriptions[1].look.color = Color{255, 0, 0};
  scene.body.descriptions[1].look.metallic = 0;
  const GlbReader glb = read(scene);
  const auto material = [&](std::size_t mesh) -> std::size_t {
    return glb.json["meshes"][mesh]["primitives"][0]["material"];
  };
  EXPECT_EQ(material(0), material(2));
  const auto& red = glb.json["materials"][material(1)]["pbrMetallicRoughness"];
  EXPECT_EQ(red["baseColorFactor"], (std::vector<double>{1, 0, 0, 1}));
  EXPECT_EQ(red["metallicFactor"], 0);
}

TEST(GltfScene, HasTheTrianglesAndColoursOfAMesh) {
  scene::Scene scene = scene::load_scene("dzhanibekov");
  const body::TriangleMesh triangles{{{-1, -2, -1}, {3, -1, -1}, {0, 3, -1}, {0, 0, 4}},
                                     {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}},
                                     {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}}};
  scene.body.parts[0].shape = body::make_mesh(triangles);
  const GlbReader glb = read(scene);
  const auto& primitive = glb.json["meshes"][0]["primitives"][0];
  const std::vector<float> colors = glb.floats(primitive["attributes"]["COLOR_0"]);
  EXPECT_EQ(colors.size(), 3U * 12) << "each triangle has normals of its own";
  EXPECT_EQ(std::count(colors.begin(), colors.end(), 1.0F), 3 * (1 + 1 + 1 + 3));
  const auto& material = glb.json["materials"][primitive["material"].get<std::size_t>()];
  EXPECT_EQ(material["pbrMetallicRoughness"]["baseColorFactor"], (std::vector<double>{1, 1, 1, 1}));
  EXPECT_FALSE(glb.json["meshes"][1]["primitives"][0]["attributes"].contains("COLOR_0"));
}

TEST(GltfScene, HasTheMaterialOfTheScene) {
  scene::Scene scene = scene::load_scene("dzhanibekov");
  scene.look.color = Color{255, 128, 0};
  scene.look.metallic = 0.25;
  scene.look.roughness = 0.5;
  const GlbReader glb = read(scene);
  const auto& material = glb.json["materials"][0]["pbrMetallicRoughness"];
  EXPECT_EQ(material["baseColorFactor"],
            nlohmann::json({1.0, picture::linear_from_srgb(128), 0.0, 1.0}));
  EXPECT_EQ(material["metallicFactor"], 0.25);
  EXPECT_EQ(material["roughnessFactor"], 0.5);
}

// The arrow of L points along L, and that of omega initially along omega.
TEST(GltfScene, HasArrowsThatPoint) {
  const scene::Scene scene = scene::load_scene("dzhanibekov");
  const motion::FreeBody body(scene::mass_properties(scene.body).inertia, scene.motion.omega);
  const GlbReader glb = read(scene);
  const auto turn = glb.json["nodes"][glb.node("L")]["rotation"].get<std::vector<double>>();
  EXPECT_LT(angle_between(Quaterniond(turn.data()) * Vector3d::UnitZ(), body.momentum()), 1e-12);
  const auto x = glb.json["nodes"][glb.node("x")]["rotation"].get<std::vector<double>>();
  EXPECT_LT(angle_between(Quaterniond(x.data()) * Vector3d::UnitZ(), Vector3d::UnitX()), 1e-12);
}

// The centre of mass is in the picture, whose shape is that of the scene's picture.
TEST(GltfScene, HasTheCameraOfTheScene) {
  scene::Scene scene = scene::load_scene("dzhanibekov");
  scene.camera.azimuth = 0.4;
  const GlbReader glb = read(scene);
  const auto& node = glb.json["nodes"][glb.node("camera")];
  const Vector3d eye(node["translation"].get<std::vector<double>>().data());
  const Quaterniond turn(node["rotation"].get<std::vector<double>>().data());
  EXPECT_NEAR(std::atan2(eye.x(), eye.z()), 0.4, 1e-12);
  const auto& lens = glb.json["cameras"][0]["perspective"];
  EXPECT_DOUBLE_EQ(lens["aspectRatio"], 16.0 / 9);
  EXPECT_LT(angle_between(turn * -Vector3d::UnitZ(), -eye), 0.5 * lens["yfov"].get<double>());
  EXPECT_NEAR((turn * Vector3d::UnitX()).y(), 0, 0.05) << "upright";
}

TEST(GltfScene, HasACameraThatSeesTheWholeArrows) {
  scene::Scene scene = scene::load_scene("dzhanibekov");
  scene.film.width = 400;  // L points to the right, where there is little room
  scene.film.height = 1600;
  const GlbReader glb = read(scene);
  const auto& camera = glb.json["nodes"][glb.node("camera")];
  const auto& lens = glb.json["cameras"][0]["perspective"];
  const auto& arrow = glb.json["nodes"][glb.node("L")];
  const Quaterniond turn(camera["rotation"].get<std::vector<double>>().data()),
      along(arrow["rotation"].get<std::vector<double>>().data());
  const auto& primitive =
      glb.json["meshes"][arrow["mesh"].get<std::size_t>()]["primitives"][0]["attributes"];
  const auto& accessor = glb.json["accessors"][primitive["POSITION"].get<std::size_t>()];
  const double length = accessor["max"][2].get<double>();
  const Vector3d eye(camera["translation"].get<std::vector<double>>().data());
  const Vector3d seen = turn.inverse() * (along * Vector3d(0, 0, length) - eye);
  const double reach = std::tan(0.5 * lens["yfov"].get<double>()) * -seen.z();
  EXPECT_LT(std::abs(seen.y()), reach);
  EXPECT_LT(std::abs(seen.x()), reach * lens["aspectRatio"].get<double>());
}

// A node that turns carries the camera, so that it is where the film's camera is at any time.
TEST(GltfScene, HasACameraThatMovesAsTheFilmsDoes) {
  scene::Scene scene = scene::load_scene("dzhanibekov");
  scene.camera.orbit = -0.2;  // rad per second of video, which is 6 s of motion
  scene.camera.frame = scene::Frame::rotating;
  const GlbReader glb = read(scene);
  EXPECT_EQ(glb.json["nodes"][glb.node("frame")]["children"][0], glb.node("orbit"));
  EXPECT_EQ(glb.json["nodes"][glb.node("orbit")]["children"][0], glb.node("camera"));
  const auto turned = [&](const char* node, double time) {
    const auto sampler = glb.sampler(node, "rotation");
    return played_rotation(numbers(glb, sampler, "input"), numbers(glb, sampler, "output"), time);
  };
  const motion::FreeBody body(scene::mass_properties(scene.body).inertia, scene.motion.omega);
  for (const double t : {0.0, 31.7, 96.0}) {
    EXPECT_LT(angle_between(turned("frame", t), motion::steady_frame(body, t).attitude), 1e-4);
    const Eigen::AngleAxisd orbit(-0.2 * t / 6, Vector3d::UnitY());
    EXPECT_LT(angle_between(turned("orbit", t), orbit.toRotationMatrix()), 1e-4);
  }
  scene.camera.frame = scene::Frame::body;
  const GlbReader along = read(scene);
  EXPECT_EQ(along.json["nodes"][along.node("body")]["children"][0], along.node("orbit"));
}

TEST(GltfScene, OfABodyAtRestHasNoArrowsOfMotion) {
  scene::Scene scene = scene::load_scene("dzhanibekov");
  scene.motion.omega.setZero();
  const GlbReader glb = read(scene);
  EXPECT_THAT(names_of(glb.json["nodes"]),
              ElementsAre("camera", "handle", "leg", "x", "y", "z", "body"));
}

TEST(GltfScene, IsTheSameBytesEachTime) {
  const scene::Scene scene = scene::load_scene("tao-disk");
  EXPECT_EQ(glb_of(gltf_scene(scene, {}, "twrench")), glb_of(gltf_scene(scene, {}, "twrench")));
}

}  // namespace
}  // namespace twrench::interchange
