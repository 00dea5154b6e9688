#include "scene/video_length.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <twrench/base/error.h>

namespace twrench::scene {
namespace {

using testing::HasSubstr;

TEST(VideoLength, KeepsTheSpeedOrTheDuration) {
  Scene cut = load_scene("dzhanibekov");
  set_video_length(cut, 4, Kept::speed, "length");
  EXPECT_EQ(cut.film.speed, 6);
  EXPECT_EQ(cut.motion.duration, 24);
  Scene slow = load_scene("dzhanibekov");
  set_video_length(slow, 32, Kept::duration, "length");
  EXPECT_EQ(slow.film.speed, 3);
  EXPECT_EQ(slow.motion.duration, 96);
  for (const Scene& scene : {cut, slow}) {
    EXPECT_EQ(scene.origins.duration, Origin::user);
    EXPECT_EQ(scene.origins.speed, Origin::user);
  }
}

TEST(VideoLength, IsWithinItsLimitsAndThoseOfTheOthers) {
  Scene scene = load_scene("dzhanibekov");
  EXPECT_THROW(set_video_length(scene, 0, Kept::speed, "length"), OutOfRange);
  scene.film.speed = 1e15;
  try {
    set_video_length(scene, 2, Kept::speed, "length");
    ADD_FAILURE();
  } catch (const InvalidArgument& error) {
    EXPECT_THAT(error.what(), HasSubstr("length: is 2 s, which makes the duration 2e+15"));
  }
  Scene story = load_scene("explain");
  EXPECT_THROW(set_video_length(story, 2, Kept::speed, "length"), InvalidArgument);
}

TEST(VideoLength, IsDescribedWithTheTimesThatItFollowsFrom) {
  Scene scene = load_scene("dzhanibekov");
  EXPECT_EQ(describe_video(scene), "96 s of motion, 6 times as fast: 16 s of video");
  scene.film.speed = 1;
  EXPECT_EQ(describe_video(scene), "96 s of motion, in real time: 96 s of video");
  EXPECT_EQ(describe_video(load_scene("toutatis")),
            "24 d of motion, 1.3e+05 times as fast: 16 s of video");
  EXPECT_THAT(describe_video(load_scene("explain")), HasSubstr(" shots: "));
}

}  // namespace
}  // namespace twrench::scene
