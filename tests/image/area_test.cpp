#include "image/area.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <random>

namespace twrench::image {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

TEST(CommonArea, IsWhatLiesInBoth) {
  EXPECT_EQ(common({0, 0, 10, 10}, {4, -3, 3, 20}), (Area{4, 0, 3, 10}));
  EXPECT_EQ(common({2, 3, 4, 5}, {2, 3, 4, 5}), (Area{2, 3, 4, 5}));
  EXPECT_EQ(common({0, 0, 10, 10}, {30, 2, 5, 5}).width, 0);
  EXPECT_EQ(common({0, 0, 10, 10}, {2, -9, 5, 5}).height, 0);
}

TEST(MergedAreas, AreOneAroundTwoThatNearlyCoincide) {
  EXPECT_THAT(merged({{10, 20, 30, 40}, {12, 19, 30, 40}}), ElementsAre(Area{10, 19, 32, 41}));
}

TEST(MergedAreas, StayApartWhereTheOneAroundThemWouldBeLarger) {
  const Area tall{0, 0, 2, 100}, wide{0, 0, 100, 2}, far{50, 50, 4, 4};
  EXPECT_THAT(merged({tall, wide, far}), UnorderedElementsAre(tall, wide, far));
  EXPECT_THAT(merged({}), IsEmpty());
}

TEST(MergedAreas, CoverAllThatWasGiven) {
  std::mt19937 random(4);
  const auto below = [&](int count) { return static_cast<int>(random() % unsigned(count)); };
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<Area> areas;
    long given = 0, left = 0;
    for (int i = 0; i < 6; ++i) {
      areas.push_back({below(40), below(40), 1 + below(20), 1 + below(20)});
      given += areas.back().width * areas.back().height;
    }
    const auto result = merged(areas);
    for (const Area& area : result) left += area.width * area.height;
    EXPECT_LE(left, given);
    for (int y = 0; y < 60; ++y) {
      for (int x = 0; x < 60; ++x) {
        const auto has = [&](const Area& a) {
          return x >= a.x && x < a.x + a.width && y >= a.y && y < a.y + a.height;
        };
        if (std::ranges::any_of(areas, has)) {
          ASSERT_TRUE(std::ranges::any_of(result, has)) << x << ' ' << y;
        }
      }
    }
  }
}

}  // namespace
}  // namespace twrench::image
