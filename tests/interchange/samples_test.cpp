#include "interchange/samples.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "scene/scene.h"

namespace twrench::interchange {
namespace {

TEST(Trajectory, TellsHowManySamplesAMethodHasComputed) {
  scene::Scene scene = scene::load_scene("dzhanibekov");
  scene.motion.duration = 1;
  for (const char* method : {"rkmk4", "exact"}) {
    scene.motion.method = method;
    const std::size_t samples = RegularTimes(scene).size();
    std::vector<std::size_t> calls;
    write_trajectory([](std::string_view) {}, scene, "csv", {},
                     [&](std::size_t done, std::size_t total) {
                       EXPECT_EQ(total, samples);
                       calls.push_back(done);
                     });
    if (scene.motion.method == std::string("exact")) {
      EXPECT_TRUE(calls.empty());
      continue;
    }
    ASSERT_EQ(calls.size(), samples);
    EXPECT_EQ(calls.front(), 1U);
    EXPECT_EQ(calls.back(), samples);
  }
}

}  // namespace
}  // namespace twrench::interchange
