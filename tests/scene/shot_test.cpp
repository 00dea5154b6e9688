#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "scene/scene.h"
#include "scene/scene_json.h"
#include "scene/scene_values.h"

namespace twrench::scene {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

TEST(SpeedCurve, IsLinearBetweenItsPointsAndConstantBeyond) {
  const SpeedCurve curve{{{1, 4}, {3, 2}, {4, 0}}};
  for (const auto& [time, speed] : {std::pair(0.0, 4.0),
                                    {1.0, 4.0},
                                    {2.0, 3.0},
                                    {3.0, 2.0},
                                    {3.5, 1.0},
                                    {4.0, 0.0},
                                    {9.0, 0.0}}) {
    EXPECT_DOUBLE_EQ(curve.at(time), speed) << time;
  }
  EXPECT_EQ(curve.fastest(), 4);
  EXPECT_EQ((SpeedCurve{{{0, 7}}}).at(3), 7);
}

TEST(SpeedCurve, HasTheIntegralOfItsValues) {
  const SpeedCurve curve{{{0.5, 4}, {3, 2}, {3.25, 0}, {5, 1}}};
  double sum = 0;
  constexpr double step = 1e-4;
  for (int i = 0; i < 70'000; ++i) {
    if (i % 1000 == 0) {
      EXPECT_NEAR(curve.integral(i * step), sum, 1e-7) << i * step;
    }
    sum += step * curve.at((i + 0.5) * step);
  }
  EXPECT_EQ((SpeedCurve{{{0, 7}}}).integral(3), 21);
}

const std::string film = R"(
[body]
moments = [3, 4, 5]
[motion]
omega = [1, 0.05, 0]
[film]
fps = 10
speed = 2
[overlay]
show = ["floor"]
)";

const std::string story = film + R"(
[[shot]]
length = 2
caption = "One"
[[shot]]
length = 3
fade = 0.5
move = 1
speed = [[0, 2], [1, 2], [3, 0]]
[shot.overlay]
show = ["floor", "omega"]
[shot.camera]
azimuth = 1.5
[[shot]]
length = 1.04
caption = "Three"
start = 7
[shot.body]
moments = [1, 2, 2.5]
[shot.motion]
omega = [0, 1, 0]
duration = 50
[[shot]]
length = 1
speed = 0
)";

TEST(Shots, AreTheSceneWithTheirOwnValues) {
  const Scene scene = parse_scene(story, "story.toml");
  ASSERT_EQ(scene.shots.size(), 4u);
  const auto& [one, two, three, four] =
      std::tie(scene.shots[0], scene.shots[1], scene.shots[2], scene.shots[3]);
  EXPECT_EQ(*one.scene.caption, "One");
  EXPECT_EQ(*two.scene.caption, "") << "room for the captions of others";
  EXPECT_EQ(one.scene.overlay.show, std::set{Feature::floor});
  EXPECT_EQ(two.scene.overlay.show, (std::set{Feature::floor, Feature::omega}));
  EXPECT_EQ(two.scene.camera.azimuth, 1.5);
  EXPECT_EQ(three.scene.camera.azimuth, 0) << "the film's, not the previous shot's";
  EXPECT_EQ(two.fade, 0.5);
  EXPECT_EQ(two.move, 1);
  EXPECT_EQ(mass_properties(three.scene.body).moments, Vector3d(1, 2, 2.5));
  EXPECT_EQ(three.scene.motion.omega, Vector3d(0, 1, 0));
  EXPECT_EQ(mass_properties(four.scene.body).moments, Vector3d(3, 4, 5));
  EXPECT_EQ(two.scene.film.speed, 2) << "its fastest";
  EXPECT_TRUE(one.scene.shots.empty());
}

TEST(Shots, GoOnWhereTheSameMotionEnded) {
  const Scene scene = parse_scene(story, "story.toml");
  EXPECT_EQ(scene.shots[0].start, 0);
  EXPECT_EQ(scene.shots[1].start, 4);
  EXPECT_EQ(scene.shots[1].time_of(3), 8);
  EXPECT_EQ(scene.shots[2].start, 7);
  EXPECT_EQ(scene.shots[3].start, 8);
  EXPECT_EQ(scene.shots[3].time_of(1), 8);
}

TEST(Shots, KnowWhetherTheyContinueThePreviousOne) {
  const Scene scene = parse_scene(story, "story.toml");
  std::vector<bool> continues;
  for (const Shot& shot : scene.shots) continues.push_back(shot.continues);
  EXPECT_EQ(continues, (std::vector{false, true, false, false}));
  const auto second_continues = [](const std::string& shot) {
    return parse_scene(film + "[[shot]]\nlength = 2\n[[shot]]\nlength = 2\n" + shot, "s.toml")
        .shots[1]
        .continues;
  };
  EXPECT_TRUE(second_continues("start = 4"));
  EXPECT_TRUE(second_continues("[shot.camera]\nframe = 'body'"));
  EXPECT_FALSE(second_continues("start = 4.1"));
  EXPECT_FALSE(second_continues("[shot.motion]\nmethod = 'rk4'"));
  EXPECT_FALSE(second_continues("[shot.motion]\nomega = [1, 0.06, 0]"));
}

/// The start of a shot with `start = "match"` after one of 2 s of a steady rotation about y at 2
/// rad per second of video.
double start_of_match(const std::string& shot) {
  const std::string rotation =
      "[body]\nmoments = [3, 4, 5]\n[motion]\nomega = [0, 1, 0]\nmethod = 'exact'\nduration = 50\n"
      "[film]\nspeed = 2\n[overlay]\nshow = []\n[[shot]]\nlength = 2\n"
      "[[shot]]\nlength = 1\nstart = 'match'\n";
  return parse_scene(rotation + shot, "match.toml").shots[1].start;
}

TEST(Shots, MatchTheAttitudeInWhichThePreviousOneEnded) {
  EXPECT_NEAR(start_of_match(""), 4, 1e-3);
  EXPECT_NEAR(start_of_match("[shot.camera]\nazimuth = 1"), 5, 1e-3) << "the body has turned too";
  EXPECT_NEAR(start_of_match("[shot.camera]\nazimuth = -1"), 3, 1e-3);
  EXPECT_NEAR(start_of_match("[shot.motion]\nomega = [0, 0.5, 0]"), 8, 2e-3);
  EXPECT_NEAR(start_of_match("[shot.motion]\nomega = [0, 2, 0]\nduration = 1"), 1, 1e-3)
      << "the nearest within its duration";
  EXPECT_EQ(start_of_match("[shot.camera]\nframe = 'body'"), 0) << "it always looks alike";
  EXPECT_EQ(start_of_match("[shot.camera]\nframe = 'rotating'"), 0);
  // From above or from the side, a body that turns about the vertical looks different.
  const double start = start_of_match("[shot.camera]\nelevation = 1.2");
  EXPECT_NEAR(start, 4, 1e-3);
}

TEST(Shots, HaveMotionsAsLongAsAnyOfThemNeeds) {
  const Scene scene = parse_scene(story, "story.toml");
  for (const std::size_t same : {0U, 1U, 3U}) {
    EXPECT_EQ(scene.shots[same].scene.motion.duration, 8) << same;
  }
  EXPECT_EQ(scene.shots[2].scene.motion.duration, 50) << "as it says";
  std::string shorter = story;
  shorter.replace(shorter.find("duration = 50"), 13, "duration = 5 ");
  EXPECT_DOUBLE_EQ(parse_scene(shorter, "story.toml").shots[2].scene.motion.duration, 7 + 2 * 1.04)
      << "but as long as it is seen";
  const Scene fading = parse_scene(film +
                                       "[[shot]]\nlength = 2\n[[shot]]\nlength = 1\nfade = 0.5\n"
                                       "[shot.body]\nmoments = [1, 2, 2.5]\n",
                                   "story.toml");
  EXPECT_DOUBLE_EQ(fading.shots[0].scene.motion.duration, 2 * 2.5) << "and while it fades out";
  const Scene frozen = parse_scene(film + "[[shot]]\nlength = 1\nspeed = 0", "story.toml");
  EXPECT_GT(frozen.shots[0].scene.motion.duration, 0);
}

TEST(Shots, BeginAtWholeFrames) {
  const Scene scene = parse_scene(story, "story.toml");
  EXPECT_EQ(first_frames(scene), (std::vector{0, 20, 50, 60, 70}));
  EXPECT_EQ(scene.frame_count(), 70);
  EXPECT_DOUBLE_EQ(scene.video_length(), 7.04);
  EXPECT_EQ(scene.shots[2].scene.video_length(), 1.04);
  EXPECT_EQ(first_frames(parse_scene(film, "film.toml")), std::vector{0});
}

TEST(Shots, WithoutCaptionsLeaveNoRoomForThem) {
  const Scene scene = parse_scene(film + "[[shot]]\nlength = 1\n", "story.toml");
  EXPECT_FALSE(scene.shots[0].scene.caption.has_value());
}

TEST(Shots, AreInTheJsonWithAllThatTheyChange) {
  const auto json = scene_json(parse_scene(story, "story.toml"));
  ASSERT_EQ(json["shot"].size(), 4u);
  EXPECT_EQ(json["shot"][1]["speed"].dump(), "[[0.0,2.0],[1.0,2.0],[3.0,0.0]]");
  EXPECT_EQ(json["shot"][1]["camera"].dump(), R"({"azimuth":1.5})");
  EXPECT_EQ(json["shot"][2]["body"]["moments"].dump(), "[1.0,2.0,2.5]");
  EXPECT_FALSE(json["shot"][3].contains("body"));
  for (const auto& [old, changed] : {std::pair("One", "Two"),
                                     {"length = 3", "length = 4"},
                                     {"fade = 0.5", "fade = 0.4"},
                                     {"move = 1", "move = 0.9"},
                                     {"[1, 2]", "[1, 1]"},
                                     {"start = 7", "start = 8"},
                                     {"azimuth = 1.5", "azimuth = 1"},
                                     {"[1, 2, 2.5]", "[1, 2, 2.4]"}}) {
    std::string other = story;
    other.replace(other.find(old), std::string(old).size(), changed);
    EXPECT_NE(scene_json(parse_scene(other, "story.toml")), json) << old;
  }
  EXPECT_FALSE(scene_json(parse_scene(film, "film.toml")).contains("shot"));
}

TEST(Shots, TakeTheValuesThatAreSetForTheFilm) {
  Scene scene = parse_scene(story, "story.toml");
  set_value(scene, "theme", "paper");
  set_value(scene, "fps", 20);
  EXPECT_EQ(scene.look.theme, Theme::paper);
  for (const Shot& shot : scene.shots) EXPECT_EQ(shot.scene.look.theme, Theme::paper);
  EXPECT_EQ(scene.frame_count(), 141);
  for (const char* key : {"duration", "speed"}) {
    EXPECT_THROW(set_value(scene, key, 3), InvalidArgument) << key;
  }
  EXPECT_THROW(set_value(scene, "omega", {1, 2, 3}), InvalidArgument);
  EXPECT_THROW(set_body(scene, {{}, Vector3d(1, 2, 3).asDiagonal()}), InvalidArgument);
}

struct BadShot {
  const char* text;  ///< Follows a film and a shot of 2 s, in line 16.
  const char* place;
  const char* why;
};

void PrintTo(const BadShot& bad, std::ostream* out) { *out << bad.text; }

class ShotMistake : public testing::TestWithParam<BadShot> {};

TEST_P(ShotMistake, IsReportedWithItsShotAndLine) {
  const std::string text = film + "[[shot]]\nlength = 2\n[shot.overlay]\nview = 'wrench'\n" +
                           "[[shot]]\n" + GetParam().text;
  try {
    parse_scene(text, "bad.toml");
    FAIL() << text;
  } catch (const InvalidArgument& error) {
    EXPECT_THAT(error.what(), HasSubstr(std::string("bad.toml:") + GetParam().place));
    EXPECT_THAT(error.what(), HasSubstr(GetParam().why));
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, ShotMistake,
    testing::Values(
        BadShot{"lenght = 2", "15: shot[1].length", "missing"},
        BadShot{"length = 2\ncapton = 'x'", "17: shot[1]", "'capton'"},
        BadShot{"length = 0", "16: shot[1].length", "is 0"},
        BadShot{"length = -1", "16: shot[1].length", "is -1"},
        BadShot{"length = nan", "16: shot[1].length", "nan"},
        BadShot{"length = 1e7", "16: shot[1].length", "at most"},
        BadShot{"length = 2\nspeed = -1", "17: shot[1].speed", "is -1"},
        BadShot{"length = 2\nspeed = 'fast'", "17: shot[1].speed", "number or an array"},
        BadShot{"length = 2\nspeed = []", "17: shot[1].speed", "no points"},
        BadShot{"length = 2\nspeed = [[0, 1], [2]]", "17: shot[1].speed", "2 numbers"},
        BadShot{"length = 2\nspeed = [[0, 1], [3, 1]]", "17: shot[1].speed", "is 3"},
        BadShot{"length = 2\nspeed = [[1, 1], [1, 2]]", "17: shot[1].speed", "at 1 s after"},
        BadShot{"length = 2\nspeed = [[0, 1], [1, -2]]", "17: shot[1].speed", "is -2"},
        BadShot{"length = 1\nfade = 1.5", "17: shot[1].fade", "at most 1 s"},
        BadShot{"length = 5\nmove = 2.5", "17: shot[1].move", "at most 2 s"},
        BadShot{"length = 5\nfade = -1", "17: shot[1].fade", "is -1"},
        BadShot{"length = 5\nmove = 1\n[shot.overlay]\nview = 'momentum'", "17: shot[1].move",
                "one body each"},
        BadShot{"length = 5\nmove = 1\n[shot.overlay]\ncompare = ['rk4', 'exact']",
                "17: shot[1].move", "one body each"},
        BadShot{"length = 5\nstart = -1", "17: shot[1].start", "is -1"},
        BadShot{"length = 5\nstart = 'mach'", "17: shot[1].start", "is 'mach', but must be"},
        BadShot{"length = 5\nstart = 'match'\n[shot.overlay]\nview = 'momentum'",
                "17: shot[1].start", "one body each"},
        BadShot{"length = 5\ncaption = 7", "17: shot[1].caption", "string"},
        BadShot{"length = 5\n[[shot.shot]]\nlength = 1", "17: shot[1]", "'shot'"},
        BadShot{"length = 5\n[shot.film]\nfps = 3", "17: shot[1]", "'film'"},
        BadShot{"length = 5\n[shot.overlay]\nfont = 'mono'", "18: shot[1].overlay.font",
                "the same in the whole film"},
        BadShot{"length = 5\n[shot.look]\nbackground = 'transparent'",
                "18: shot[1].look.background", "the same in the whole film"},
        BadShot{"length = 5\n[shot.camera]\nelevation = 3", "18: shot[1].camera.elevation",
                "at most 1.57"},
        BadShot{"length = 5\n[shot.overlay]\ncompare_omega = [[1, 2]]",
                "18: shot[1].overlay.compare_omega", "3 numbers"},
        BadShot{"length = 5\n[shot.overlay]\ncompare_omega = "
                "[[1,0,0],[1,0,0],[1,0,0],[1,0,0],[1,0,0]]",
                "18: shot[1].overlay.compare_omega", "at most 4"},
        BadShot{"length = 5\n[[shot.part]]\nshape = 'sphere'\nradius = 0\ndensity = 1",
                "19: shot[1].part[0].radius", "is 0"}));

TEST(Shots, TheFirstFollowsNoOther) {
  for (const char* key : {"fade", "move"}) {
    try {
      parse_scene(film + "[[shot]]\nlength = 2\n" + key + " = 1", "bad.toml");
      FAIL() << key;
    } catch (const InvalidArgument& error) {
      EXPECT_THAT(error.what(), HasSubstr(fmt::format("bad.toml:13: shot[0].{}", key)));
    }
  }
}

TEST(Shots, TheFirstMatchesNoOther) {
  try {
    parse_scene(film + "[[shot]]\nlength = 2\nstart = 'match'", "bad.toml");
    FAIL();
  } catch (const InvalidArgument& error) {
    EXPECT_THAT(error.what(), HasSubstr("bad.toml:13: shot[0].start: 'match' needs"));
  }
}

TEST(Shots, AreNoMoreThanTheLimit) {
  std::string text = film;
  for (int i = 0; i < 1001; ++i) text += "[[shot]]\nlength = 1\n";
  EXPECT_THROW(parse_scene(text, "bad.toml"), InvalidArgument);
}

TEST(Shots, OfTooManyFramesAreRefused) {
  const Scene scene =
      parse_scene(film + "[[shot]]\nlength = 1e6\n[[shot]]\nlength = 1e6", "s.toml");
  EXPECT_THROW(scene.frame_count(), InvalidArgument);
}

}  // namespace
}  // namespace twrench::scene
