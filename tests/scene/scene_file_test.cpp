#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <twrench/motion/exact.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "scene/recording_file.h"
#include "scene/scene.h"
#include "scene/scene_json.h"
#include "scratch_folder.h"
#include "system/error.h"
#include "system/file.h"

namespace twrench::scene {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

TEST(SceneFile, BuiltInScenesLoad) {
  for (const std::string& name : builtin_scene_names()) {
    const Scene scene = load_scene(name);
    EXPECT_EQ(scene.name, name);
    EXPECT_FALSE(scene.title.empty());
    if (!scene.shots.empty()) continue;
    EXPECT_EQ(scene.frame_count(), 960) << name;
  }
}

TEST(SceneFile, EachSceneOfTheFolderIsBuiltInOnce) {
  std::vector<std::string> files;
  for (const auto& entry :
       std::filesystem::directory_iterator(TWRENCH_TESTS_DIR "/../assets/scenes")) {
    if (entry.path().extension() == ".toml") files.push_back(entry.path().stem().string());
  }
  EXPECT_THAT(builtin_scene_names(), testing::UnorderedElementsAreArray(files));
  EXPECT_EQ(builtin_scene_names().front(), "dzhanibekov") << "the default is listed first";
}

TEST(SceneFile, NestedTooDeeplyIsRefusedWithoutNamesOfTheParser) {
  try {
    parse_scene("[body]\nmoments = " + std::string(300, '[') + std::string(300, ']'), "a.toml");
    FAIL();
  } catch (const InvalidArgument& error) {
    EXPECT_STREQ(error.what(), "a.toml:2: arrays and tables are nested more than 256 deep");
  }
}

TEST(SceneFile, MayBeginWithAByteOrderMark) {
  EXPECT_EQ(parse_scene("\xEF\xBB\xBFtitle = 'a'\n[body]\nmoments = [2, 3, 4]\n", "a.toml").title,
            "a");
}

TEST(SceneFile, NamesARecordingWithoutReadingIt) {
  const Scene scene = parse_scene(
      "[body]\nmoments = [2, 3, 4]\n[motion]\nfile = 'run.csv'\nto = 2\ninverse = true\n",
      "folder/a.toml");
  const RecordingFile& recording = *scene.motion.recording_file;
  EXPECT_EQ(recording.file, "run.csv");
  EXPECT_EQ(recording.path, "folder/run.csv");
  EXPECT_EQ(recording.from, -INFINITY);
  EXPECT_EQ(recording.to, 2);
  EXPECT_TRUE(recording.convention.inverse);
  EXPECT_THAT(input_files(scene), testing::Contains("folder/run.csv"));
  EXPECT_EQ(scene_json(scene)["motion"]["recording"],
            nlohmann::ordered_json({{"file", "run.csv"}, {"to", 2.0}, {"inverse", true}}));
  EXPECT_FALSE(parse_scene("[body]\nmoments = [2, 3, 4]\n", "a.toml").motion.recording_file);
}

TEST(SceneFile, ThatIsAnotherFileWithAWrongNameIsNamed) {
  using namespace std::string_literals;
  const ScratchFolder folder;
  const std::string path = folder / "a.toml";
  for (const auto& [bytes, kind] : {std::pair("\xFF\xD8\xFF\xE0\0"s, "a JPEG picture"),
                                    {"<!DOCTYPE html>\n"s, "an HTML page"},
                                    {"\xFF\xFEt\0"s, "text in UTF-16, not in UTF-8"},
                                    {"t\0i\0t\0l\0e\0"s, "text in UTF-16, not in UTF-8"}}) {
    system::write_file_atomically(path, bytes);
    try {
      load_scene(path);
      FAIL() << kind;
    } catch (const InvalidArgument& error) {
      EXPECT_EQ(error.what(), fmt::format("{}: it is {}", path, kind));
      EXPECT_THAT(error.remedy(), HasSubstr("name a scene file, .toml"));
    }
  }
}

// The words after "cannot read this" are those of the parser, which differ between its versions.
TEST(SceneFile, WithAMistakeInItsSyntaxIsRefusedWithARemedy) {
  const auto refusal = [](const std::string& text) -> std::string {
    try {
      parse_scene(text, "a.toml");
    } catch (const InvalidArgument& error) {
      return fmt::format("{}; {}", error.what(), error.remedy());
    }
    return "none";
  };
  EXPECT_THAT(refusal("title = 'a'\n[film]\nfps ="),
              AllOf(StartsWith("a.toml:3: cannot read this "), EndsWith("; complete it")));
  EXPECT_THAT(refusal("title = 'a'\ntitle = 'b'"), AllOf(StartsWith("a.toml:2: cannot read this "),
                                                         EndsWith("; remove one of the two")));
  EXPECT_THAT(refusal("title = a name"),
              AllOf(StartsWith("a.toml:1: cannot read this "),
                    EndsWith("; a line is KEY = VALUE or [TABLE]; a text is in quotes")));
}

// Each shot has a separate body.
TEST(SceneFile, HasALimitOfPartsInAllShots) {
  std::string text;
  for (int i = 0; i < 1000; ++i) {
    text += "[[part]]\nshape = 'sphere'\nradius = 1\ndensity = 1\n";
  }
  for (int i = 0; i < 51; ++i) text += "[[shot]]\nlength = 1\n";
  try {
    parse_scene(text, "a.toml");
    FAIL();
  } catch (const InvalidArgument& error) {
    EXPECT_STREQ(error.what(),
                 "a.toml:4101: shot[50]: the shots have at most 50000 parts together");
  }
}

TEST(SceneFile, Tasks) {
  EXPECT_EQ(load_scene("dzhanibekov").motion.omega, Vector3d(1, 0.05, 0));
  EXPECT_EQ(load_scene("stable-y").motion.omega, Vector3d(0, 1, 0.05));
  EXPECT_EQ(load_scene("stable-z").motion.omega, Vector3d(0.05, 0, 1));
  const Eigen::Matrix3d I = mass_properties(load_scene("sphere").body).inertia;
  EXPECT_LE((I - Eigen::Matrix3d::Identity()).norm(), 1e-15);
}

TEST(SceneFile, CalmSpinsThreeAndAHalfTurnsBeforeItFlips) {
  const Scene scene = load_scene("calm");
  EXPECT_EQ(scene.motion.omega, Vector3d(1, 0.001, 0));
  const motion::FreeBody body(mass_properties(scene.body).inertia, scene.motion.omega);
  const auto flips = motion::ExactMotion(body).flips();
  ASSERT_TRUE(flips && flips->turns_over());
  EXPECT_NEAR(flips->first * scene.motion.omega.norm() / (2 * std::numbers::pi), 3.57, 0.01);
}

constexpr const char* full = R"(
title = "All keys"
[[part]]
shape = "box"
size = [1, 2, 3]
density = 2
rotation = [0.1, 0.2, 0.3]
[[part]]
shape = "ellipsoid"
radii = [1.0, 2.0, 3.0]
density = 1.5
position = [1, 0, 0]
[motion]
omega = [0.5, -1, 2]
method = "rk4"
step = 0.25
tolerance = 1e-8
duration = 12
[film]
size = [640, 360]
fps = 25
text_fade = 0.4
speed = 2
[look]
theme = "paper"
samples = 1
motion_blur = 8
background = "transparent"
color = "#ff8800"
metallic = 0.5
roughness = 0.2
[camera]
azimuth = 1.5
elevation = -0.5
distance = 2
orbit = 0.1
field_of_view = 0.4
[overlay]
view = "quad"
show = ["axes", "plane"]
forces = ["coriolis", "sum"]
compare = ["rk4", "exact"]
trail_point = [1, 2, 3]
trail_length = 7
star_trail = 1.5
font = "mono"
)";

TEST(SceneFile, EveryKeyIsRead) {
  const Scene scene = parse_scene(full, "folder/some.toml");
  EXPECT_EQ(scene.name, "some");
  EXPECT_EQ(scene.title, "All keys");
  ASSERT_EQ(scene.body.parts.size(), 2u);
  EXPECT_EQ(std::get<body::Box>(scene.body.parts[0].shape).size, Vector3d(1, 2, 3));
  EXPECT_EQ(scene.body.parts[0].density, 2);
  EXPECT_NE(scene.body.parts[0].body_from_part, Eigen::Matrix3d::Identity());
  EXPECT_EQ(std::get<body::Ellipsoid>(scene.body.parts[1].shape).radii, Vector3d(1, 2, 3));
  EXPECT_EQ(scene.body.parts[1].position, Vector3d(1, 0, 0));
  EXPECT_EQ(scene.motion.omega, Vector3d(0.5, -1, 2));
  EXPECT_EQ(scene.motion.method, "rk4");
  EXPECT_EQ(scene.motion.control.step, 0.25);
  EXPECT_EQ(scene.motion.control.tolerance, 1e-8);
  EXPECT_EQ(scene.motion.duration, 12);
  EXPECT_EQ(scene.film.width, 640);
  EXPECT_EQ(scene.film.height, 360);
  EXPECT_EQ(scene.film.fps, 25);
  EXPECT_EQ(scene.film.text_fade, 0.4);
  EXPECT_EQ(scene.film.speed, 2);
  EXPECT_EQ(scene.look.samples, 1);
  EXPECT_EQ(scene.look.theme, Theme::paper);
  EXPECT_EQ(scene.look.motion_blur, 8);
  EXPECT_TRUE(scene.look.transparent);
  EXPECT_EQ(scene.look.color, (Color{255, 136, 0}));
  EXPECT_EQ(scene.look.metallic, 0.5);
  EXPECT_EQ(scene.look.roughness, 0.2);
  EXPECT_EQ(scene.camera.azimuth, 1.5);
  EXPECT_EQ(scene.camera.elevation, -0.5);
  EXPECT_EQ(scene.camera.distance, 2);
  EXPECT_EQ(scene.camera.orbit, 0.1);
  EXPECT_EQ(scene.camera.field_of_view, 0.4);
  EXPECT_EQ(scene.overlay.view, View::quad);
  EXPECT_EQ(scene.overlay.show, (std::set{Feature::axes, Feature::plane}));
  EXPECT_EQ(scene.overlay.forces, (std::set{Force::coriolis, Force::sum}));
  EXPECT_EQ(scene.overlay.compare, (std::vector<std::string>{"rk4", "exact"}));
  EXPECT_EQ(scene.overlay.trail_point, Vector3d(1, 2, 3));
  EXPECT_EQ(scene.overlay.trail_length, 7);
  EXPECT_EQ(scene.overlay.star_trail, 1.5);
  EXPECT_EQ(scene.overlay.font, "mono");
  EXPECT_EQ(scene.frame_count(), 150);
  EXPECT_EQ(scene.film.time_of(3), 3 * 2.0 / 25);
}

TEST(SceneFile, MomentsAlone) {
  const Scene scene = parse_scene("[body]\nmoments = [3, 4, 5]", "m.toml");
  const body::MassProperties body = mass_properties(scene.body);
  EXPECT_TRUE(std::isnan(body.mass));
  EXPECT_EQ(body.moments, Vector3d(3, 4, 5));
  EXPECT_EQ(visible_parts(scene.body).size(), 1u);
}

// Integers that no double represents are rounded, like decimal numbers.
TEST(SceneFile, WholeNumbersOfAnySizeAreRead) {
  const Scene scene = parse_scene(
      "[body]\nmoments = [9007199254740993, 9223372036854775807, 9007199254740992]", "m.toml");
  EXPECT_EQ(mass_properties(scene.body).inertia.diagonal(),
            Vector3d(9007199254740992.0, 9223372036854775808.0, 9007199254740992.0));
}

// At the limits of its values, a body still has finite properties and a motion.
TEST(SceneFile, WhatTheLimitsAllowHasAMotion) {
  for (const double length : {1e-9, 1e6}) {
    for (const double density : {1e-9, 1e6}) {
      const std::string text = fmt::format(
          "[[part]]\nshape = 'box'\nsize = [{0}, {0}, {0}]\ndensity = {1}\n"
          "axis = [1e-300, 1e-300, 0]\nposition = [1e12, -1e12, 1e12]\n",
          length, density);
      const body::MassProperties body = mass_properties(parse_scene(text, "m.toml").body);
      const double moment = density * std::pow(length, 5) / 6;
      EXPECT_LE((body.inertia / moment - Eigen::Matrix3d::Identity()).norm(), 1e-14) << text;
    }
  }
}

TEST(SceneFile, VisiblePartsStandAboutTheCentreOfMass) {
  const Scene scene = parse_scene(
      "[[part]]\nshape = 'sphere'\nradius = 1\ndensity = 1\nposition = [5, 0, 0]", "s.toml");
  EXPECT_EQ(visible_parts(scene.body)[0].position, Vector3d::Zero());
}

TEST(SceneFile, ADiagonalInertiaIsTheSameAsMoments) {
  const Scene matrix =
      parse_scene("[body]\ninertia = [[3, 0, 0], [0, 4, -0.0], [0, 0, 5]]", "m.toml");
  const Scene moments = parse_scene("[body]\nmoments = [3, 4, 5]", "m.toml");
  EXPECT_EQ(scene_json(matrix), scene_json(moments));
  EXPECT_EQ(scene_json(matrix)["body"].dump(), R"({"moments":[3.0,4.0,5.0],"shape":"box"})");
}

TEST(SceneFile, AnInertiaMatrixIsWrittenAsItWasRead) {
  const std::string rows = "[[3.0,0.25,-0.1],[0.25,4.0,0.3],[-0.1,0.3,5.0]]";
  const Scene scene = parse_scene("[body]\nshape = 'cross'\ninertia = " + rows, "m.toml");
  EXPECT_EQ(scene_json(scene)["body"].dump(), R"({"inertia":)" + rows + R"(,"shape":"cross"})");
  Matrix3d expected;
  expected << 3, 0.25, -0.1, 0.25, 4, 0.3, -0.1, 0.3, 5;
  EXPECT_EQ(mass_properties(scene.body).inertia, expected);
  EXPECT_EQ(visible_parts(scene.body).size(), 7u);
  EXPECT_EQ(part_groups(scene.body).at(1).name, "heavy discs");
  EXPECT_EQ(part_groups(scene.body, Language::nb).at(1).name, "tunge skiver");
}

// Entries that another program printed with 15 digits may differ in the last one.
TEST(SceneFile, AnInertiaMatrixIsSymmetricToRoundOff) {
  const Scene scene = parse_scene(
      "[body]\ninertia = [[3, 0.1, 0], [0.1000000000000002, 4, 0], [0, 0, 5]]", "m.toml");
  const Matrix3d& inertia = *scene.body.inertia;
  EXPECT_EQ(inertia, inertia.transpose());
  EXPECT_DOUBLE_EQ(inertia(0, 1), 0.1000000000000001);
}

struct Mistake {
  const char* text;
  const char* place;
  const char* why;
};

void PrintTo(const Mistake& mistake, std::ostream* out) { *out << mistake.place; }

class SceneMistake : public testing::TestWithParam<Mistake> {};

TEST_P(SceneMistake, IsReportedWithItsPlace) {
  try {
    parse_scene(GetParam().text, "bad.toml");
    FAIL() << GetParam().text;
  } catch (const InvalidArgument& error) {
    EXPECT_THAT(error.what(), HasSubstr(GetParam().place));
    EXPECT_THAT(error.what(), HasSubstr(GetParam().why));
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, SceneMistake,
    testing::Values(
        Mistake{"title = ", "bad.toml:1", ""},
        Mistake{"[body]\nmoments = [1,2,3]\ntitel = 1", "bad.toml:3: body", "'titel'"},
        Mistake{"[body]\nmoments = [1,2,3]\n[film]\nfsp = 1", "bad.toml:4: film", "'fsp'"},
        Mistake{"titel = 'x'\n[body]\nmoments = [1,2,3]", "bad.toml:1", "'titel'"},
        Mistake{"[body]\nmoments = [1,2,-3]", "bad.toml:2: body.moments", "is -3"},
        Mistake{"[body]\nmoments = [1,2]", "bad.toml:2: body.moments", "3 numbers"},
        Mistake{"[body]\nmoments = [1,2,'3']", "bad.toml:2: body.moments", "number"},
        Mistake{"[body]\nmoments = [1,2,nan]", "bad.toml:2: body.moments", "nan"},
        Mistake{"[body]\nmoments = [1,2,inf]", "bad.toml:2: body.moments", "inf"},
        Mistake{"[body]\nmoments=[1,2,3]\n[motion]\nomega = [1, 2, 9007199254740993]",
                "bad.toml:4: motion.omega", "is 9007199254740992"},
        Mistake{"[body]\nmoments = [1e-107, 1e-107, 1e-107]", "bad.toml:2: body.moments",
                "must be at least 1e-60 and at most 1e+30"},
        Mistake{"[body]\nmoments = [1e30, 1e30, 1]", "bad.toml:2: body.moments",
                "the largest must be at most 1e+12 times the smallest"},
        Mistake{"[body]\nshape = 'box'", "bad.toml:1: body", "has neither moments nor inertia"},
        Mistake{"[body]\ninertia = [[2,0,0],[0,3,0],[0,0,4]]\nmoments = [2,3,4]",
                "bad.toml:2: body.inertia", "moments give the inertia already"},
        Mistake{"[body]\ninertia = [2,3,4]", "bad.toml:2: body.inertia",
                "must be an array of three rows of three numbers"},
        Mistake{"[body]\ninertia = 3", "body.inertia", "three rows of three numbers"},
        Mistake{"[body]\ninertia = [[2,0,0],[0,3,0]]", "body.inertia", "three rows"},
        Mistake{"[body]\ninertia = [[2,0],[0,3],[0,0]]", "body.inertia", "three rows"},
        Mistake{"[body]\ninertia = [[2,0,0],[0,3,0],[0,0,'4']]", "bad.toml:2: body.inertia",
                "must be a number"},
        Mistake{"[body]\ninertia = [[2,0.5,0],[0.6,3,0],[0,0,4]]", "bad.toml:2: body.inertia",
                "must be symmetric, but Ixy is 0.5 and Iyx is 0.6"},
        Mistake{"[body]\ninertia = [[2,0,0],[0,3,1],[0,-1,4]]", "body.inertia",
                "Iyz is 1 and Izy is -1"},
        Mistake{"[body]\ninertia = [[2,nan,0],[nan,3,0],[0,0,4]]", "body.inertia", "is nan"},
        Mistake{"[body]\ninertia = [[2,inf,0],[inf,3,0],[0,0,4]]", "body.inertia", "is inf"},
        Mistake{"[body]\ninertia = [[2,0,0],[0,nan,0],[0,0,4]]", "body.inertia", "is nan"},
        Mistake{"[body]\ninertia = [[2,0,0],[0,-3,0],[0,0,4]]", "body.inertia", "is -3"},
        Mistake{"[body]\ninertia = [[2,3,0],[3,2,0],[0,0,4]]", "bad.toml:2: body.inertia",
                "its principal moments are -1, 4 and 5, but each must be positive"},
        Mistake{"[body]\ninertia = [[1e30,1e29,0],[1e29,1e30,0],[0,0,1e30]]", "body.inertia",
                "but must be at least 1e-60 and at most 1e+30"},
        Mistake{"[body]\ninertia = [[1,0.9999999999999,0],[0.9999999999999,1,0],[0,0,1]]",
                "body.inertia", "the largest must be at most 1e+12 times the smallest"},
        Mistake{"[[part]]\nshape = 'sphere'\nradius = 1e-300\ndensity = 1",
                "bad.toml:3: part[0].radius", "must be at least 1e-09 and at most 1000000"},
        Mistake{"[[part]]\nshape = 'cylinder'\nradius = 1e-9\nlength = 1e6\ndensity = 1",
                "bad.toml:1: part", "the largest must be at most 1e+12 times the smallest"},
        Mistake{"[body]\nmoments=[1,2,3]\n[motion]\nomega = [0, 1e-160, 0]",
                "bad.toml:4: motion.omega",
                "has magnitude 1e-160 rad/s, but must be zero or at least"},
        Mistake{"title = 'x'", "part", "or by both"},
        Mistake{"[[part]]\nshape = 'sphere'\nradius = 1\ndensity = 0",
                "bad.toml:4: part[0].density", "at least 1e-09 and at most 1000000"},
        Mistake{"[[part]]\nshape = 'sphere'\nradius = 1\ndensity = -2",
                "bad.toml:4: part[0].density", "is -2"},
        Mistake{"[[part]]\nshape = 'sphere'\nradius = 1", "bad.toml:1: part[0].density", "missing"},
        Mistake{"[[part]]\nshape = 'spere'\nradius = 1", "bad.toml:2: part[0].shape", "'spere'"},
        Mistake{"[[part]]\nshape = 'cylinder'\nradius = 1\nlength = 1\ndensity = 1\n"
                "axis = [0, 0, 0]",
                "bad.toml:6: part[0].axis", "zero"},
        Mistake{"[[part]]\nshape = 'sphere'\nradius = 1\ndensity = 1\naxis = [1,0,0]\n"
                "rotation = [1,0,0]",
                "bad.toml:6: part[0].rotation", "combined with axis"},
        Mistake{"part = 3", "bad.toml:1: part", "array of tables"},
        Mistake{"body = 3", "bad.toml:1: body", "table"},
        Mistake{"[body]\nmoments=[1,2,3]\n[motion]\nmethod = 'rk5'", "bad.toml:4: motion.method",
                "'rk5'"},
        Mistake{"[body]\nmoments=[1,2,3]\n[motion]\nstep = 0", "bad.toml:4: motion.step", "is 0"},
        Mistake{"[body]\nmoments=[1,2,3]\n[motion]\nduration = -1", "motion.duration", "is -1"},
        Mistake{"[body]\nmoments=[1,2,3]\n[film]\nsize = [640, 0]", "film.size", "is 0"},
        Mistake{"[body]\nmoments=[1,2,3]\n[film]\nsize = [640.5, 360]", "film.size", "integer"},
        Mistake{"[body]\nmoments=[1,2,3]\n[film]\nfps = true", "film.fps", "number"},
        Mistake{"[body]\nmoments=[1,2,3]\n[look]\ntheme = 'papper'", "look.theme", "'papper'"},
        Mistake{"[body]\nmoments=[1,2,3]\n[overlay]\nview = 'quat'", "overlay.view", "'quat'"},
        Mistake{"[body]\nmoments=[1,2,3]\n[overlay]\nshow = ['hut']", "overlay.show", "'hut'"},
        Mistake{"[body]\nmoments=[1,2,3]\n[overlay]\nshow = [1]", "overlay.show",
                "array of strings"},
        Mistake{"[body]\nmoments=[1,2,3]\n[overlay]\nshow = 'hud'", "overlay.show",
                "array of strings"},
        Mistake{"[body]\nmoments=[1,2,3]\n[overlay]\ncompare = ['rk5']", "overlay.compare",
                "'rk5'"},
        Mistake{"[body]\nmoments=[1,2,3]\n[overlay]\ncompare = "
                "['rk4', 'rk4', 'rk4', 'rk4', 'rk4']",
                "overlay.compare", "at most 4"},
        Mistake{"[body]\nmoments=[1,2,3]\n[look]\ncolor = 'pink'", "look.color", "'pink'"},
        Mistake{"[body]\nmoments=[1,2,3]\n[look]\nbackground = 7", "look.background", "string"},
        Mistake{"[body]\nmoments=[1,2,3]\n[camera]\nelevation = 2", "camera.elevation",
                "at most 1.57"}));

TEST(SceneFile, UnknownSceneOffersTheNearest) {
  try {
    load_scene("dzanibekov");
    FAIL();
  } catch (const InvalidArgument& error) {
    EXPECT_THAT(error.remedy(), HasSubstr("did you mean 'dzhanibekov'?"));
  }
}

TEST(SceneFile, MissingFileIsAFileError) {
  EXPECT_THROW(load_scene("no/such.toml"), system::FileError);
  EXPECT_THROW(load_scene(TWRENCH_TESTS_DIR "/../tests.toml"), system::FileError);
}

TEST(Scene, FrameCountIsBounded) {
  Scene scene = load_scene("sphere");
  scene.motion.duration = 1e9;
  scene.film.speed = 0.001;
  EXPECT_THROW(scene.frame_count(), InvalidArgument);
  scene.motion.duration = 1e-6;
  scene.film.speed = 1;
  EXPECT_THROW(scene.frame_count(), InvalidArgument);
}

TEST(SceneFile, GroupsPartsByTheirNames) {
  const auto names = [](const Body& body) {
    std::vector<std::string> result;
    for (const PartGroup& group : part_groups(body)) {
      result.push_back(group.name + " x" + std::to_string(group.parts.size()));
    }
    return result;
  };
  EXPECT_THAT(names(load_scene("dzhanibekov").body), testing::ElementsAre("handle x1", "leg x1"));
  EXPECT_THAT(names(load_scene("tao-disk").body),
              testing::ElementsAre("disc x1", "heavy balls x2", "light balls x2"));
  EXPECT_THAT(names(load_scene("sphere").body), testing::ElementsAre("part 1 x1"));
  EXPECT_THAT(names({{}, Vector3d(1, 2, 3).asDiagonal()}), testing::ElementsAre("part 1 x1"));
  EXPECT_EQ(scene_json(load_scene("dzhanibekov"))["part"][1]["name"], "leg");
}

}  // namespace
}  // namespace twrench::scene
