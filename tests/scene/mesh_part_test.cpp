// Parts that are meshes: the location of their files, the resulting parts, and the errors for bad
// files.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "sanitizers.h"
#include "scene/scene.h"
#include "scene/scene_json.h"
#include "scratch_folder.h"
#include "system/bytes.h"
#include "system/error.h"

namespace twrench::scene {
namespace {

using Eigen::Vector3d;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* tetrahedron =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

/// A tetrahedron without its fourth face.
constexpr const char* open_tetrahedron =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\n";

class MeshPart : public testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) {
    std::filesystem::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name) << text;
  }

  /// A scene file in the folder with one part, which has the mesh file and these keys.
  Scene load(const std::string& keys, const std::string& file = "t.obj") {
    write("some.toml", "[[part]]\nshape = 'mesh'\nfile = '" + file + "'\n" + keys + "\n");
    return load_scene((folder_ / "some.toml").string());
  }

  template <typename Error = InvalidArgument>
  std::string refused(const std::string& keys, const std::string& file = "t.obj") {
    try {
      load(keys, file);
    } catch (const Error& error) {
      return error.what() + (error.remedy().empty() ? "" : "; " + error.remedy());
    }
    return "not refused";
  }

  ScratchFolder folder_;
};

// A few kilobytes of scene file would take minutes if each scale read the mesh again.
TEST_F(MeshPart, IsNotReadTooOftenInOtherSizes) {
  if (has_sanitizers) GTEST_SKIP() << "takes long for large meshes";
  std::string many = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  constexpr int copies = 20'000;
  for (int i = 1; i < copies; ++i) {
    many += fmt::format("v {0} 0 0\nv {1} 0 0\nv {0} 1 0\nv {0} 0 1\n", 2 * i, 2 * i + 1);
  }
  for (int i = 0; i < copies; ++i) {
    many += fmt::format("f {0} {2} {1}\nf {0} {1} {3}\nf {0} {3} {2}\nf {1} {2} {3}\n", 4 * i + 1,
                        4 * i + 2, 4 * i + 3, 4 * i + 4);
  }
  write("t.obj", many);
  const auto parts = [](int count, const char* key) {
    std::string text;
    for (int i = 1; i < count; ++i) {
      text += fmt::format("[[part]]\nshape = 'mesh'\nfile = 't.obj'\n{}\n",
                          fmt::vformat(key, fmt::make_format_args(i)));
    }
    return text;
  };
  EXPECT_EQ(
      load("scale = 1\ndensity = 1\n" + parts(5, "scale = 1.{}\ndensity = 1")).body.parts.size(),
      5U);
  EXPECT_THAT(
      refused("scale = 1\ndensity = 1\n" + parts(4, "scale = 1\nweld = 0.00{}\ndensity = 1")),
      HasSubstr("read it too often"));
}

TEST_F(MeshPart, HasTheMassOfItsSolid) {
  write("t.obj", tetrahedron);
  const body::MassProperties body = mass_properties(load("unit = 'cm'\ndensity = 6").body);
  EXPECT_NEAR(body.mass, 1, 1e-15);
  EXPECT_LE((body.centre_of_mass - Vector3d(0.25, 0.25, 0.25)).norm(), 1e-15);
  const body::MassProperties large = mass_properties(load("unit = 'mm'\nmass = 5").body);
  EXPECT_NEAR(large.mass, 5, 1e-14);
  EXPECT_LE((large.centre_of_mass - Vector3d(0.025, 0.025, 0.025)).norm(), 1e-16);
  EXPECT_LE((large.inertia - 5e-2 * body.inertia).norm(), 1e-15);
  const body::MassProperties scaled = mass_properties(load("scale = 100\nmass = 5").body);
  EXPECT_LE((scaled.centre_of_mass - Vector3d(25, 25, 25)).norm(), 1e-13);
}

TEST_F(MeshPart, IsPlacedByTheOriginOfItsFile) {
  write("t.obj", tetrahedron);
  const Scene scene = load("unit = 'cm'\ndensity = 6\nposition = [10, 0, 0]");
  EXPECT_EQ(scene.body.parts[0].position, Vector3d(10, 0, 0));
  EXPECT_LE((mass_properties(scene.body).centre_of_mass - Vector3d(10.25, 0.25, 0.25)).norm(),
            1e-14);
  EXPECT_LE((visible_parts(scene.body)[0].position + Vector3d(0.25, 0.25, 0.25)).norm(), 1e-14);
}

TEST_F(MeshPart, MayBeAWallAlongAnOpenSurface) {
  write("t.obj", open_tetrahedron);
  const Scene scene = load("unit = 'cm'\ndensity = 2\nshell = 0.1");
  EXPECT_NEAR(mass_properties(scene.body).mass, 2 * 0.1 * 1.5, 1e-15);
  EXPECT_EQ(std::get<body::Mesh>(scene.body.parts[0].shape).shell, 0.1);
  EXPECT_THAT(refused("unit = 'cm'\ndensity = 2"), HasSubstr("shell"));
  EXPECT_THAT(refused("unit = 'cm'\ndensity = 2\nshell = 0"),
              HasSubstr("some.toml:6: part[0].shell: is 0, but must be at least"));
}

TEST_F(MeshPart, IsFoundFromTheFolderOfTheSceneFile) {
  write("deep/er/t.obj", tetrahedron);
  write("deep/some.toml", "[[part]]\nshape='mesh'\nfile='er/t.obj'\nunit='cm'\ndensity=1\n");
  const Scene scene = load_scene((folder_ / "deep/some.toml").string());
  EXPECT_EQ(description(scene.body, 0).mesh->file, "er/t.obj");
  EXPECT_EQ(description(scene.body, 0).mesh->path, folder_ / "deep/er/t.obj");
  const std::string absolute = (folder_ / "deep/er/t.obj").string();
  EXPECT_NO_THROW(load("unit = 'cm'\ndensity = 1", absolute));
}

TEST_F(MeshPart, IsABuiltInOneWhereThereIsNoSuchFile) {
  const auto count = [](const Scene& scene) {
    return std::get<body::Mesh>(scene.body.parts[0].shape).surface->triangles.size();
  };
  const Scene built_in = load("unit = 'km'\ndensity = 2", "toutatis.obj");
  EXPECT_EQ(count(built_in), 12796u);
  EXPECT_EQ(description(built_in.body, 0).mesh->path, "");
  EXPECT_THAT(input_files(built_in), ElementsAre("sans"));
  write("toutatis.obj", tetrahedron);
  EXPECT_EQ(count(load("unit = 'km'\ndensity = 2", "toutatis.obj")), 4u);
}

TEST_F(MeshPart, IsInTheJsonWithTheDigestOfItsFile) {
  write("t.obj", tetrahedron);
  const auto json =
      scene_json(load("unit = 'mm'\ndensity = 6\nweld = 1e-6\ncrease = 0.5"))["part"][0];
  EXPECT_EQ(json["shape"], "mesh");
  EXPECT_EQ(json["file"], "t.obj");
  EXPECT_EQ(json["scale"], 0.1);
  EXPECT_EQ(json["weld"], 1e-6);
  EXPECT_EQ(json["shell"], 0);
  EXPECT_EQ(json["crease"], 0.5);
  const std::string text = tetrahedron;
  EXPECT_EQ(json["sha256"],
            system::sha256_hex({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}));
}

TEST_F(MeshPart, OfNoFileHasTheDigestOfItsTriangles) {
  write("t.obj", tetrahedron);
  Scene scene = load("unit = 'mm'\ndensity = 6");
  scene.body.descriptions.clear();
  const auto json = scene_json(scene)["part"][0];
  EXPECT_FALSE(json.contains("file"));
  EXPECT_EQ(json["sha256"].get<std::string>().size(), 64u);
  auto mesh = std::get<body::Mesh>(scene.body.parts[0].shape);
  body::TriangleMesh other = *mesh.surface;
  other.vertices[0].x() += 1e-15;
  mesh.surface = std::make_shared<body::TriangleMesh>(other);
  scene.body.parts[0].shape = mesh;
  EXPECT_NE(scene_json(scene)["part"][0]["sha256"], json["sha256"]);
}

TEST_F(MeshPart, IsReadOnceForAllPartsAndShots) {
  write("t.obj", tetrahedron);
  const std::string part = "shape = 'mesh'\nfile = 't.obj'\nunit = 'cm'\ndensity = 1\n";
  write("some.toml", "[[part]]\n" + part + "[[part]]\n" + part + "position = [3, 0, 0]\n" +
                         "[[shot]]\nlength = 1\n[[shot.part]]\n" + part);
  const Scene scene = load_scene((folder_ / "some.toml").string());
  const auto surface = [](const Body& body, std::size_t i) {
    return std::get<body::Mesh>(body.parts[i].shape).surface;
  };
  EXPECT_EQ(surface(scene.body, 0), surface(scene.body, 1));
  EXPECT_EQ(surface(scene.body, 0), surface(scene.shots[0].scene.body, 0));
}

TEST_F(MeshPart, IsAnInputOfTheScene) {
  write("t.obj", tetrahedron);
  write("u.obj", tetrahedron);
  write("some.toml",
        "[[part]]\nshape = 'mesh'\nfile = 't.obj'\nunit = 'cm'\ndensity = 1\n[overlay]\nfont = "
        "'f.ttf'\n[[shot]]\nlength = 1\n[[shot.part]]\nshape = 'mesh'\nfile = 'u.obj'\nunit = "
        "'cm'\ndensity = 1\n");
  EXPECT_THAT(input_files(load_scene((folder_ / "some.toml").string())),
              ElementsAre("f.ttf", folder_ / "t.obj", "f.ttf", folder_ / "u.obj"));
}

TEST_F(MeshPart, OfABadFileIsReportedWithItsPlace) {
  write("t.obj", tetrahedron);
  const std::string place = "some.toml:3: part[0].file: ";
  EXPECT_THAT(refused<system::FileError>("unit = 'cm'\ndensity = 1", "none.obj"),
              AllOf(HasSubstr(place), HasSubstr("none.obj: No such file")));
  EXPECT_THAT(refused<system::FileError>("unit = 'cm'\ndensity = 1", "."), HasSubstr(place));
  EXPECT_THAT(refused<system::FileError>("unit = 'cm'\ndensity = 1", "/dev/zero"),
              HasSubstr(place));
  ASSERT_EQ(::mkfifo((folder_ / "pipe.obj").c_str(), 0600), 0);
  EXPECT_THAT(refused<system::FileError>("unit = 'cm'\ndensity = 1", "pipe.obj"),
              AllOf(HasSubstr(place), HasSubstr("not a regular file")));
  EXPECT_THAT(refused("unit = 'cm'\ndensity = 1", ""), HasSubstr(place + "is not the path"));
  write("some.toml", "[[part]]\nshape = 'mesh'\nfile = \"t.obj\\u0000x\"\nunit='cm'\ndensity = 1");
  try {
    load_scene((folder_ / "some.toml").string());
    FAIL();
  } catch (const InvalidArgument& error) {
    EXPECT_THAT(error.what(), HasSubstr(place + "is not the path"));
  }
  write("bad.obj", open_tetrahedron);
  EXPECT_THAT(refused("unit = 'cm'\ndensity = 1", "bad.obj"),
              AllOf(HasSubstr(place), HasSubstr("bad.obj")));
}

TEST_F(MeshPart, NeedsItsUnit) {
  write("t.obj", tetrahedron);
  EXPECT_THAT(refused("density = 1"),
              AllOf(HasSubstr("some.toml:3: part[0].file: "), HasSubstr("unit")));
  EXPECT_THAT(refused("unit = 'cm'\nscale = 1\ndensity = 1"),
              HasSubstr("some.toml:5: part[0].scale: cannot be combined with unit"));
  EXPECT_THAT(refused("unit = 'ft'\ndensity = 1"), HasSubstr("some.toml:4: part[0].unit"));
  EXPECT_THAT(refused("scale = 0\ndensity = 1"),
              HasSubstr("some.toml:4: part[0].scale: is 0, but must be at least"));
  EXPECT_THAT(refused("unit = 'cm'\nweld = -1\ndensity = 1"),
              HasSubstr("some.toml:5: part[0].weld: is -1"));
  EXPECT_THAT(refused("unit = 'cm'\ncrease = 4\ndensity = 1"),
              HasSubstr("some.toml:5: part[0].crease: is 4"));
  EXPECT_THAT(refused("scale = 1e10\ndensity = 1"),
              AllOf(HasSubstr("some.toml:3: part[0].file: the mesh is 1.73205e+10 cm across"),
                    HasSubstr("check its unit")));
}

TEST_F(MeshPart, OfTheLargestAndTheSmallestSizeHasAMotion) {
  write("t.obj", tetrahedron);
  for (const char* scale : {"1e-9", "5e8"}) {
    for (const char* density : {"1e-9", "1e6"}) {
      const Scene scene = load(std::string("scale = ") + scale + "\ndensity = " + density);
      const double mass = std::stod(density) * std::pow(std::stod(scale), 3) / 6;
      const body::MassProperties body = mass_properties(scene.body);
      EXPECT_NEAR(body.mass / mass, 1, 1e-14);
      EXPECT_NEAR(body.inertia.trace() / (mass * std::pow(std::stod(scale), 2)), 0.225, 1e-3);
    }
  }
}

}  // namespace
}  // namespace twrench::scene
