#include "scene/mesh_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <twrench/base/error.h>
#include <twrench/motion/exact.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "scene/motion_summary.h"
#include "scratch_folder.h"
#include "system/file.h"

namespace twrench::scene {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

motion::ExactMotion exact_motion(const Scene& scene) {
  return motion::ExactMotion(
      motion::FreeBody(mass_properties(scene.body).inertia, scene.motion.omega));
}

/// An OBJ file of a prism along z over a regular polygon of that radius; 4 corners give a box.
std::string prism(int corners, double radius, double length) {
  std::ostringstream text;
  text.precision(17);
  for (const double z : {-length / 2, length / 2}) {
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * std::numbers::pi * i / corners;
      text << "v " << radius * std::cos(angle) << ' ' << radius * std::sin(angle) << ' ' << z
           << '\n';
    }
  }
  const auto face = [&](bool top) {
    text << 'f';
    for (int i = 0; i < corners; ++i) text << ' ' << (top ? corners + 1 + i : corners - i);
    text << '\n';
  };
  face(false);
  face(true);
  for (int i = 0; i < corners; ++i) {
    const int next = (i + 1) % corners;
    text << "f " << i + 1 << ' ' << next + 1 << ' ' << corners + next + 1 << ' ' << corners + i + 1
         << '\n';
  }
  return text.str();
}

/// A box of 2 x 3 x 4.
const std::string box_obj =
    "v 0 0 0\nv 2 0 0\nv 2 3 0\nv 0 3 0\nv 0 0 4\nv 2 0 4\nv 2 3 4\nv 0 3 4\n"
    "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

class MeshScene : public testing::Test {
 protected:
  Scene scene_of(const std::string& obj, double scale = 1, const std::string& name = "x.obj") {
    system::write_file_atomically(folder_ / name, obj);
    return mesh_scene((folder_ / name).string(), {.scale = scale}, [](double) { return 2.0; });
  }

  ScratchFolder folder_;
};

TEST_F(MeshScene, TurnsOverThreeTimesAndIsNamedAfterItsFile) {
  const Scene scene = scene_of(box_obj, 1, "my box.obj");
  EXPECT_EQ(scene.name, "my box");
  EXPECT_EQ(scene.title, "my box");
  EXPECT_DOUBLE_EQ(mass_properties(scene.body).mass, 48);
  EXPECT_EQ(scene.motion.omega, Vector3d(0, 1, 0.05)) << "about the intermediate axis";
  EXPECT_EQ(exact_motion(scene).flip_times(scene.motion.duration).size(), 3U);
  EXPECT_EQ(scene_of(box_obj, 1, "two\nlines\x7F.obj").title, "two lines ");
  ASSERT_EQ(input_files(scene).size(), 2U);
  EXPECT_EQ(input_files(scene)[1], folder_ / "my box.obj");
}

TEST_F(MeshScene, HasTheSameTimesWhateverItsSize) {
  const Scene usual = scene_of(box_obj);
  for (const double scale : {1e-6, 1e-3, 1e3, 1e6}) {
    const Scene scene = scene_of(box_obj, scale);
    EXPECT_EQ(scene.motion.omega, usual.motion.omega) << scale;
    EXPECT_EQ(scene.motion.duration, usual.motion.duration) << scale;
    EXPECT_EQ(scene.film.speed, usual.film.speed) << scale;
  }
}

TEST_F(MeshScene, OfASymmetricBodyWobbles) {
  for (const auto& [length, symmetric] : {std::pair{0.2, "disc"}, {8.0, "rod"}}) {
    const Scene scene = scene_of(prism(64, 1, length));
    EXPECT_FALSE(exact_motion(scene).flips()) << symmetric;
    EXPECT_TRUE(scene.motion.omega.isApprox(Vector3d(0.29552, 0, 0.955336), 1e-9)) << symmetric;
    EXPECT_GT(scene.motion.duration, 10 * scene.film.speed * 0.9) << symmetric;
  }
}

TEST_F(MeshScene, OfASymmetricBodyDoesNotDependOnRounding) {
  body::MassProperties body{};
  body.moments = {2, 2, 3};
  for (const double angle : {0.0, 0.3, 2.0, 4.0}) {
    const Vector3d u(std::cos(angle), std::sin(angle), 1e-17), v(-u.y(), u.x(), -1e-17);
    for (const bool swapped : {false, true}) {
      body.axes.col(0) = swapped ? v : u;
      body.axes.col(1) = swapped ? u : v;
      body.axes.col(2) = body.axes.col(0).cross(body.axes.col(1));
      const Vector3d omega = natural_omega(body);
      EXPECT_EQ(omega, Vector3d(0.29552, 0, 0.955336)) << angle;
      EXPECT_FALSE(std::signbit(omega.y())) << "a zero without a sign";
    }
  }
}

// The moments of a symmetric mesh differ by the rounding of its coordinates.
TEST_F(MeshScene, OfABodyThatIsSymmetricUpToRoundingIsDescribedAsSymmetric) {
  std::string text = prism(3, 1, 4);
  const Scene exact = scene_of(text);
  const std::size_t digit = text.find_first_of("123456789", text.find("0.8660") + 10);
  text[digit] = text[digit] == '9' ? '8' : static_cast<char>(text[digit] + 1);
  const Scene rounded = scene_of(text);
  const Vector3d moments = mass_properties(rounded.body).moments;
  EXPECT_NE(moments[0], moments[1]);
  EXPECT_EQ(rounded.motion.omega, exact.motion.omega);
  EXPECT_EQ(rounded.motion.duration, exact.motion.duration);
  EXPECT_THAT(motion_summary(rounded), HasSubstr("does not flip"));
  EXPECT_FALSE(motion::ExactMotion(free_body(rounded)).flips());
}

TEST_F(MeshScene, OfABodyWithThreeEqualMomentsSpins) {
  for (const double length : {1.0, 1.004}) {
    const Scene scene = scene_of(prism(4, std::sqrt(0.5), length));
    EXPECT_EQ(scene.motion.omega, Vector3d::UnitX()) << length;
    EXPECT_EQ(scene.motion.duration, 100) << length;
  }
}

TEST_F(MeshScene, OfAnAlmostSymmetricBodyTurnsOver) {
  for (const double factor : {1.001, 1.1}) {
    for (const Vector3d& moments : {Vector3d(3, 3 * factor, 5 * factor), {1, 4, 4 * factor}}) {
      body::MassProperties body{};
      body.moments = moments;
      body.axes.setIdentity();
      const motion::ExactMotion motion(motion::FreeBody(moments.asDiagonal(), natural_omega(body)));
      ASSERT_TRUE(motion.flips()) << moments.transpose();
      EXPECT_TRUE(motion.flips()->turns_over()) << moments.transpose();
      EXPECT_LT(motion.flips()->interval, 1000) << moments.transpose();
    }
  }
}

TEST_F(MeshScene, IsSeenWithItsMomentumAcrossThePicture) {
  const Scene along_y = scene_of(box_obj);
  EXPECT_EQ(along_y.camera.azimuth, 0) << "upright";
  std::string turned = box_obj;  // the intermediate axis along z
  for (std::size_t at = 0; (at = turned.find("v ", at)) != std::string::npos; at += 7) {
    std::swap(turned[at + 4], turned[at + 6]);
  }
  const Scene along_z = scene_of(turned);
  EXPECT_NEAR(std::abs(along_z.camera.azimuth), std::numbers::pi / 2, 0.1);
}

TEST_F(MeshScene, IsLoadedByItsName) {
  system::write_file_atomically(folder_ / "box.obj", box_obj);
  try {
    load_scene((folder_ / "box.obj").string());
    ADD_FAILURE() << "it has no unit";
  } catch (const InvalidArgument& error) {
    EXPECT_THAT(error.what(), HasSubstr("box.obj: its unit is not known"));
  }
}

TEST_F(MeshScene, HasTheLimitsOfSceneFiles) {
  EXPECT_THROW(scene_of(box_obj, 1e9), InvalidArgument) << "4e9 cm";
  EXPECT_THROW(scene_of(prism(3, 1, 1e7), 1e-2), InvalidArgument) << "moments of 1 : 1e13";
}

TEST_F(MeshScene, OfAnUnknownFormatIsRefusedWithTheKnownOnes) {
  const std::string file = (folder_ / "x.step").string();
  system::write_file_atomically(file, "ISO-10303-21;\n");
  try {
    load_scene(file);
    ADD_FAILURE();
  } catch (const InvalidArgument& error) {
    EXPECT_THAT(error.what(), testing::EndsWith("x.step: it is a STEP model"));
    EXPECT_THAT(error.remedy(), HasSubstr("a mesh: .obj .stl .ply .gltf .glb .dae .3mf"));
  }
}

}  // namespace
}  // namespace twrench::scene
