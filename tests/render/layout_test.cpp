#include "render/layout.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "render/t_wrench.h"

namespace twrench {
namespace {

constexpr std::pair<int, int> sizes[]{
    {320, 180},   {480, 270},   {640, 360},   {854, 480},   {1280, 720}, {1920, 1080}, {3840, 2160},
    {180, 320},   {540, 960},   {1080, 1920}, {2160, 3840}, {240, 240},  {720, 720},   {1080, 1080},
    {400, 300},   {800, 600},   {1440, 1080}, {600, 800},   {840, 360},  {2560, 1080}, {1080, 2560},
    {1100, 1000}, {1000, 1100}, {160, 90},    {64, 48},     {16, 16},    {16384, 16},  {16, 16384}};

bool overlap(const Area& a, const Area& b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

bool inside(const Area& a, const Area& b) {
  return a.width > 0 && a.height > 0 && a.x >= b.x && a.y >= b.y &&
         a.x + a.width <= b.x + b.width && a.y + a.height <= b.y + b.height;
}

std::string text(const Area& a) {
  return std::to_string(a.x) + "," + std::to_string(a.y) + " " + std::to_string(a.width) + "x" +
         std::to_string(a.height);
}

std::vector<Area> words_and_insets(const Layout& layout, View view) {
  std::vector<Area> areas = layout.legends;
  for (const auto& area : {layout.title, layout.figures, layout.components}) {
    if (area) areas.push_back(*area);
  }
  if (view == View::wrench) {
    for (const auto& inset : {layout.momentum, layout.poinsot}) {
      if (inset) areas.push_back(inset->area);
    }
  }
  return areas;
}

/// All that is not to be covered: the words, the insets, and the focus of each view.
std::vector<Area> all_areas(const Layout& layout, View view) {
  std::vector<Area> areas = words_and_insets(layout, view);
  for (const Layout::Pane& pane : layout.panes) areas.push_back(pane.focus);
  if (view != View::wrench) {
    for (const auto& pane : {layout.momentum, layout.poinsot}) {
      if (pane) areas.push_back(pane->focus);
    }
  }
  return areas;
}

std::vector<Scene> scenes(View view, int compared) {
  std::vector<Scene> scenes;
  for (const auto& [width, height] : sizes) {
    Scene scene = t_wrench(width, height);
    scene.overlay.view = view;
    scene.overlay.show.insert(Feature::poinsot);
    scene.overlay.compare.assign(static_cast<std::size_t>(compared), "exact");
    for (int without = 0; without < 4; ++without) {
      const Feature left_out[]{Feature::poinsot, Feature::sphere, Feature::components,
                               Feature::hud};
      scenes.push_back(scene);
      scene.overlay.show.erase(left_out[without]);
    }
    scenes.push_back(scene);
  }
  return scenes;
}

class LayoutOf : public testing::TestWithParam<std::pair<View, int>> {};

TEST_P(LayoutOf, KeepsWordsAndInsetsInTheSafeArea) {
  for (const Scene& scene : scenes(GetParam().first, GetParam().second)) {
    const auto [width, height] = std::pair(scene.film.width, scene.film.height);
    const Layout layout = layout_of(scene);
    for (const Area& area : words_and_insets(layout, scene.overlay.view)) {
      EXPECT_GE(area.x, 0.05 * width) << text(area) << " of " << width << "x" << height;
      EXPECT_GE(area.y, 0.05 * height) << text(area) << " of " << width << "x" << height;
      EXPECT_LE(area.x + area.width, 0.95 * width)
          << text(area) << " of " << width << "x" << height;
      EXPECT_LE(area.y + area.height, 0.95 * height)
          << text(area) << " of " << width << "x" << height;
    }
  }
}

TEST_P(LayoutOf, CoversNothing) {
  for (const Scene& scene : scenes(GetParam().first, GetParam().second)) {
    const Area picture{0, 0, scene.film.width, scene.film.height};
    const std::vector<Area> areas = all_areas(layout_of(scene), scene.overlay.view);
    for (std::size_t i = 0; i < areas.size(); ++i) {
      EXPECT_TRUE(inside(areas[i], picture)) << text(areas[i]) << " in " << text(picture);
      for (std::size_t j = 0; j < i; ++j) {
        EXPECT_FALSE(overlap(areas[i], areas[j]))
            << text(areas[i]) << " and " << text(areas[j]) << " in " << text(picture);
      }
    }
  }
}

TEST_P(LayoutOf, LeavesTheBodyAThirdOfItsPaneAndPanesTile) {
  for (const Scene& scene : scenes(GetParam().first, GetParam().second)) {
    const Layout layout = layout_of(scene);
    long long pixels = 0;
    for (const auto& [area, focus] : layout.panes) {
      EXPECT_TRUE(inside(focus, area)) << text(focus) << " in " << text(area);
      EXPECT_GE(3 * std::min(focus.width, focus.height), std::min(area.width, area.height));
      pixels += static_cast<long long>(area.width) * area.height;
    }
    if (scene.overlay.view == View::wrench) {
      EXPECT_EQ(pixels, static_cast<long long>(scene.film.width) * scene.film.height);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, LayoutOf,
                         testing::Values(std::pair(View::wrench, 0), std::pair(View::wrench, 2),
                                         std::pair(View::wrench, 3), std::pair(View::wrench, 4),
                                         std::pair(View::momentum, 0), std::pair(View::poinsot, 0),
                                         std::pair(View::quad, 0)));

TEST(Layout, GivesTheBareBodyTheWholePicture) {
  for (const auto& [width, height] : sizes) {
    Scene scene = t_wrench(width, height);
    scene.overlay.show = {Feature::floor, Feature::trail, Feature::momentum};
    const Layout layout = layout_of(scene);
    ASSERT_EQ(layout.panes.size(), 1U);
    EXPECT_EQ(layout.panes[0].area, (Area{0, 0, width, height}));
    EXPECT_EQ(layout.panes[0].focus, (Area{0, 0, width, height}));
  }
}

TEST(Layout, DropsInTheStatedOrder) {
  std::size_t before = 5;
  std::set<std::size_t> counts;
  for (int height = 1080; height >= 20; height -= 4) {
    Scene scene = t_wrench(height * 16 / 9, height);
    scene.overlay.show.insert(Feature::poinsot);
    const Layout layout = layout_of(scene);
    const std::vector<bool> kept{layout.title.has_value(), layout.figures.has_value(),
                                 layout.components.has_value(), layout.momentum.has_value(),
                                 layout.poinsot.has_value()};
    EXPECT_TRUE(std::ranges::is_sorted(kept, std::greater())) << height;
    const auto count = static_cast<std::size_t>(std::ranges::count(kept, true));
    EXPECT_LE(count, before) << "what has found no room finds none in a smaller picture: "
                             << height;
    before = count;
    counts.insert(count);
  }
  EXPECT_THAT(counts, testing::IsSupersetOf({5U, 4U, 2U, 0U}));
}

TEST(Layout, ShowsAllOfTheDefaultFilmInFullSizes) {
  for (const auto& [width, height] :
       {std::pair(1920, 1080), {1080, 1920}, {1080, 1080}, {1440, 1080}, {2560, 1080}}) {
    const Layout layout = layout_of(t_wrench(width, height));
    EXPECT_TRUE(layout.title && layout.figures && layout.components && layout.momentum) << width;
    EXPECT_FALSE(layout.compact);
    const Area& focus = layout.panes[0].focus;
    EXPECT_GE(std::min(focus.width, focus.height), 0.55 * std::min(width, height)) << width;
  }
}

TEST(Layout, SetsTheWordsOfSmallPicturesNoSmallerThanCanBeRead) {
  EXPECT_TRUE(layout_of(t_wrench(320, 180)).title);
  EXPECT_TRUE(layout_of(t_wrench(320, 180)).figures);
  EXPECT_GE(layout_of(t_wrench(320, 180)).text.caption, 9);
  EXPECT_DOUBLE_EQ(layout_of(t_wrench(3840, 2160)).text.title,
                   2 * layout_of(t_wrench(1920, 1080)).text.title);
}

TEST(Layout, RefusesAComparisonInAViewOfOneMotion) {
  Scene scene = t_wrench(640, 360);
  scene.overlay.compare = {"rk4", "exact"};
  for (const View view : {View::momentum, View::poinsot, View::quad}) {
    scene.overlay.view = view;
    EXPECT_THROW(layout_of(scene), UsageError);
  }
}

}  // namespace
}  // namespace twrench
