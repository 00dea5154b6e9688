#include "picture/space/screen_area.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace twrench::picture {
namespace {

using Eigen::Vector2d;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr image::Area pane{40, 20, 300, 200};
constexpr int band = 32;

/// Returns clip coordinates of a position in the picture, in pixels from its top left.
Eigen::Vector4f clip(const Vector2d& place, double w = 1) {
  const Vector2d share((place.x() - pane.x) / pane.width, (place.y() - pane.y) / pane.height);
  return (w * Eigen::Vector4d(2 * share.x() - 1, 1 - 2 * share.y(), 0, 1)).cast<float>();
}

bool holds(const image::Area& area, const Vector2d& place) {
  return place.x() >= area.x && place.x() <= area.x + area.width && place.y() >= area.y &&
         place.y() <= area.y + area.height;
}

bool bands_overlap(const image::Area& a, const image::Area& b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

/// Adds the bar from `from` to `to`, `width` wide, as a separate shape.
void add_bar(ScreenArea& screen, const Vector2d& from, const Vector2d& to, double width) {
  const Vector2d along = (to - from).normalized();
  const Vector2d half = 0.5 * width * Vector2d(-along.y(), along.x());
  screen.begin_shape();
  for (const Vector2d& end : {from, to}) {
    screen.add(clip(end - half, 2));
    screen.add(clip(end + half, 0.5));
  }
}

TEST(ScreenArea, BoundsAllWithAPixelToSpare) {
  ScreenArea screen(pane);
  screen.begin_shape();
  screen.add(clip({100.5, 60.5}));
  screen.begin_shape(2);
  screen.add(clip({150.5, 90.5}));
  EXPECT_EQ(screen.bounds(), (image::Area{99, 59, 55, 35}));
}

TEST(ScreenArea, StaysInThePane) {
  ScreenArea screen(pane);
  screen.begin_shape();
  for (const double far : {-1e9, 1e9}) screen.add(clip({far, far}));
  EXPECT_EQ(screen.bounds(), pane);
  EXPECT_THAT(ScreenArea(pane).bands(band), IsEmpty());
}

TEST(ScreenArea, IsTheWholePaneWhereAPointIsBehindTheEye) {
  ScreenArea screen(pane);
  screen.begin_shape();
  screen.add(clip({100, 60}));
  screen.add(clip({100, 60}, -1));
  EXPECT_EQ(screen.bounds(), pane);
  EXPECT_THAT(screen.bands(band), ElementsAre(pane));
}

TEST(ScreenArea, HoldsEveryPointOfConvexShapesInBandsThatDoNotOverlap) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> anywhere(-100, 400), share(0, 1);
  for (int round = 0; round < 200; ++round) {
    ScreenArea screen(pane);
    std::vector<std::vector<Vector2d>> shapes(3);
    for (auto& corners : shapes) {
      screen.begin_shape();
      for (int i = 0; i < 1 + round % 5; ++i) {
        corners.emplace_back(anywhere(random), anywhere(random));
        screen.add(clip(corners.back()));
      }
    }
    const auto bands = screen.bands(band);
    for (const auto& corners : shapes) {
      for (int i = 0; i < 50; ++i) {
        Vector2d place = corners.front();  // a random point of the shape: a mixture of its corners
        for (const Vector2d& corner : corners) place += share(random) * (corner - place);
        if (!holds(pane, place)) continue;
        EXPECT_TRUE(std::ranges::any_of(bands, [&](const image::Area& a) {
          return holds(a, place);
        })) << place.transpose();
      }
    }
    for (std::size_t i = 0; i < bands.size(); ++i) {
      EXPECT_EQ(bands[i].y / band, (bands[i].y + bands[i].height - 1) / band)
          << "rows of the picture";
      EXPECT_TRUE(holds(pane, {bands[i].x, bands[i].y}) &&
                  holds(pane, {bands[i].x + bands[i].width, bands[i].y + bands[i].height}));
      for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(bands_overlap(bands[i], bands[j]));
    }
  }
}

TEST(ScreenArea, TakesOfEachBandNoMoreThanTheShapesDo) {
  ScreenArea screen(pane);
  add_bar(screen, {80, 40}, {240, 200}, 10);
  add_bar(screen, {240, 40}, {80, 200}, 10);
  const double across = 10 * std::sqrt(2.0), reach = 160 + across;  // of a bar along a row, of both
  double taken = 0;
  for (const image::Area& area : screen.bands(band)) {
    // At most two bars and a gap too narrow to separate them.
    EXPECT_LE(area.width, 2 * (band + across + 6) + 32);
    taken += 1.0 * area.width * area.height;
  }
  EXPECT_GT(taken, 2 * 160 * across);
  EXPECT_LT(taken, 0.6 * reach * reach);
}

TEST(ScreenArea, IsTheWholePaneForWhatIsNoNumber) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  for (const Eigen::Vector4f& clip :
       {Eigen::Vector4f(nan, 0, 0, 1), {0, infinity, 0, 1}, {0, 0, 0, nan}, {0, 0, 0, infinity}}) {
    ScreenArea screen(pane);
    screen.begin_shape();
    screen.add(clip);
    EXPECT_EQ(screen.bounds(), pane);
    EXPECT_EQ(screen.bands(band), std::vector{pane});
  }
}

TEST(ScreenArea, PartsShapesThatAreFarApartAndJoinsThoseThatAreNear) {
  for (const auto& [place, count] : {std::pair(180.0, 2U), {110.0, 1U}}) {
    ScreenArea screen(pane);
    for (const double x : {80.0, place}) add_bar(screen, {x, 70}, {x + 10, 70}, 6);
    EXPECT_EQ(screen.bands(band).size(), count) << place;
  }
}

// If there are many points, most are removed before the hull is computed.
TEST(ScreenArea, OfManyPointsIsThatOfTheOutermost) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0, 1);
  for (const double flatness : {1.0, 0.01, 0.0}) {
    ScreenArea all(pane), outer(pane);
    all.begin_shape();
    outer.begin_shape();
    const auto at = [&](double radius, double angle) {
      return Vector2d(180 + radius * std::cos(angle), 120 + flatness * radius * std::sin(angle));
    };
    for (int i = 0; i < 30; ++i) {
      all.add(clip(at(90, 0.21 * i)));
      outer.add(clip(at(90, 0.21 * i)));
    }
    for (int i = 0; i < 500; ++i) all.add(clip(at(89 * share(random), 7 * share(random))));
    EXPECT_EQ(all.bands(band), outer.bands(band)) << flatness;
    EXPECT_EQ(all.bounds(), outer.bounds());
  }
}

}  // namespace
}  // namespace twrench::picture
