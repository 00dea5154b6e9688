#include "scene/fraction.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <twrench/base/error.h>

#include <nlohmann/json.hpp>

#include "scene/scene.h"
#include "scene/scene_values.h"

namespace twrench::scene {
namespace {

TEST(Fraction, IsTheQuotientOfTwoWholeNumbers) {
  EXPECT_EQ(parse_fraction("30000/1001", "fps"), 30000.0 / 1001.0);
  EXPECT_EQ(parse_fraction("1/3", "fps"), 1.0 / 3.0);
  EXPECT_EQ(parse_fraction("1000000/1000000", "fps"), 1.0);
}

TEST(Fraction, OfAnythingElseIsRefused) {
  for (const char* text :
       {"",      "/",      "30",    "30/",       "/1001",     "30/0",
        "0/30",  "-30/1",  "30/-1", "30.0/1",    "30/1.5",    " 30/1",
        "30/1 ", "30/1/1", "1e3/1", "1000001/1", "1/1000001", "99999999999999999999/1",
        "nan/1", "+30/1"}) {
    EXPECT_THROW(parse_fraction(text, "fps"), InvalidArgument) << text;
  }
}

Scene scene_of_film(const std::string& film) {
  return parse_scene("[body]\nmoments = [1, 2, 3]\n[film]\n" + film + "\n", "a.toml");
}

TEST(Fraction, IsAFrameRateOfASceneFileAndOfAValue) {
  EXPECT_EQ(scene_of_film("fps = \"24000/1001\"").film.fps, 24000.0 / 1001.0);
  EXPECT_EQ(scene_of_film("fps = 24").film.fps, 24.0);
  Scene changed = scene_of_film("fps = 24");
  set_value(changed, "fps", "60000/1001");
  EXPECT_EQ(changed.film.fps, 60000.0 / 1001.0);
  for (const char* film :
       {"fps = \"fast\"", "fps = \"9999/1\"", "fps = [30, 1]", "speed = \"1/2\""}) {
    EXPECT_THAT([&] { scene_of_film(film); },
                testing::ThrowsMessage<InvalidArgument>(testing::HasSubstr("a.toml:4: film.")))
        << film;
  }
  EXPECT_THROW(set_value(changed, "fps", nullptr), InvalidArgument);
}

}  // namespace
}  // namespace twrench::scene
