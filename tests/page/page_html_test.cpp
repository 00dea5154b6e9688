#include "page/page_html.h"

#include <gtest/gtest.h>
#include <twrench/motion/exact.h>

#include <cmath>

#include "scene/scene.h"

namespace twrench::page {
namespace {

using scene::Scene;

/// The speed that the page offers first: a power of 2 (web/app/state.js).
double offered(double speed) { return std::exp2(std::floor(std::log2(1.1 * speed))); }

TEST(ShownScene, HasFlipsThatAreSecondsApart) {
  int turn_over = 0;
  for (const auto& name : scene::builtin_scene_names()) {
    const Scene shown = shown_scene(scene::load_scene(name));
    const motion::FreeBody body = scene::free_body(shown);
    if (!body.is_rigid()) continue;
    const auto flips = motion::ExactMotion(body).flips();
    if (!flips || !flips->turns_over()) continue;
    ++turn_over;
    const double seconds = flips->interval / offered(shown.film.speed);
    EXPECT_GE(seconds, 2) << name;
    EXPECT_LE(seconds, 10) << name;
    const double intervals = shown.motion.duration / flips->interval;
    EXPECT_GE(intervals, 2.999) << name;
    EXPECT_LE(intervals, 5.001) << name;
  }
  EXPECT_GT(turn_over, 8);
}

TEST(ShownScene, HasTheTimesThatTheUserGave) {
  Scene scene = scene::load_scene("explain");
  scene.film.speed = 1.5;
  scene.motion.duration = 77;
  scene.origins.speed = scene.origins.duration = scene::Origin::user;
  const Scene shown = shown_scene(scene);
  EXPECT_EQ(shown.film.speed, 1.5);
  EXPECT_EQ(shown.motion.duration, 77);
}

}  // namespace
}  // namespace twrench::page
