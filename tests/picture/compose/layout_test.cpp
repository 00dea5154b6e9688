#include "picture/compose/layout.h"

#include <gmock/gmock.h>
#include <twrench/base/error.h>

#include <functional>

#include "base/enumeration.h"
#include "picture/t_wrench.h"
#include "sanitizers.h"

namespace twrench::picture {
namespace {

/// Picture sides, combined with each other: from 1:1024 to 1024:1.
constexpr int sides[]{16,  17,   20,   24,   33,   48,   64,   72,   90,   100,  135,
                      164, 180,  240,  270,  300,  360,  480,  540,  600,  728,  854,
                      996, 1000, 1080, 1280, 1600, 1920, 2160, 2400, 3840, 8192, 16384};

bool overlap(const image::Area& a, const image::Area& b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

bool inside(const image::Area& a, const image::Area& b) {
  return a.width > 0 && a.height > 0 && a.x >= b.x && a.y >= b.y &&
         a.x + a.width <= b.x + b.width && a.y + a.height <= b.y + b.height;
}

std::vector<Layout::Pane> all_panes(const Layout& layout) {
  std::vector<Layout::Pane> panes = layout.panes;
  for (const auto& pane : layout.insets) {
    if (pane) panes.push_back(*pane);
  }
  return panes;
}

std::string text(const image::Area& a) {
  return std::to_string(a.x) + "," + std::to_string(a.y) + " " + std::to_string(a.width) + "x" +
         std::to_string(a.height);
}

std::vector<image::Area> words_and_insets(const Layout& layout, scene::View view) {
  std::vector<image::Area> areas = layout.legends;
  for (const auto& area :
       {layout.title, layout.readouts, layout.description, layout.components, layout.curve,
        layout.angle, layout.forces, layout.tilt, layout.moments, layout.torques}) {
    if (area) areas.push_back(*area);
  }
  for (const auto& pane : layout.insets) {
    if (pane && pane->heading) areas.push_back(*pane->heading);
  }
  if (view == scene::View::wrench) {
    for (const auto& inset : layout.insets) {
      if (inset) areas.push_back(inset->area);
    }
  }
  return areas;
}

/// Returns all areas that must not overlap: text, insets, and the focus of each view.
std::vector<image::Area> all_areas(const Layout& layout, scene::View view) {
  std::vector<image::Area> areas = words_and_insets(layout, view);
  for (const Layout::Pane& pane : layout.panes) areas.push_back(pane.focus);
  if (view != scene::View::wrench) {
    for (const auto& pane : layout.insets) {
      if (pane) areas.push_back(pane->focus);
    }
  }
  return areas;
}

/// Calls `check` for each size, with all optional items and with each selection of them.
void for_each_layout(scene::View view, int compared,
                     const std::function<void(const scene::Scene&, const Layout&)>& check) {
  std::vector<scene::Feature> features{scene::Feature::components, scene::Feature::curve,
                                       scene::Feature::hud, scene::Feature::forces};
  for (const scene::Inset& inset : scene::insets) features.push_back(inset.feature);
  scene::Scene scene = t_wrench();
  scene.overlay.view = view;
  scene.overlay.compare.assign(static_cast<std::size_t>(compared), "exact");
  for (unsigned choice = 0; choice < 1U << features.size(); ++choice) {
    scene.overlay.show = {scene::Feature::floor, scene::Feature::labels};
    for (unsigned i = 0; i < features.size(); ++i) {
      if ((choice >> i & 1U) != 0) scene.overlay.show.insert(features[i]);
    }
    if (scene.overlay.shows(scene::Feature::forces)) {
      scene.overlay.show.insert(
          {scene::Feature::torques, scene::Feature::tilt, scene::Feature::moments});
      scene.camera.frame = scene::Frame::rotating;
    }
    for (const int width : sides) {
      for (const int height : sides) {
        scene.film.width = width;
        scene.film.height = height;
        check(scene, compute_layout(scene));
        if (testing::Test::HasFailure()) return;  // one failure is enough
      }
    }
  }
}

std::string text(const scene::Scene& scene) {
  std::string shown;
  for (const scene::Feature feature : scene.overlay.show) {
    shown += " " + std::string(enumerator_name(feature));
  }
  return std::to_string(scene.film.width) + "x" + std::to_string(scene.film.height) + shown;
}

void expect_safe_words_and_insets(const scene::Scene& scene, const Layout& layout) {
  const auto [width, height] = std::pair(scene.film.width, scene.film.height);
  for (const image::Area& area : words_and_insets(layout, scene.overlay.view)) {
    EXPECT_GE(area.x, 0.05 * width) << text(area) << " of " << text(scene);
    EXPECT_GE(area.y, 0.05 * height) << text(area) << " of " << text(scene);
    EXPECT_LE(area.x + area.width, 0.95 * width) << text(area) << " of " << text(scene);
    EXPECT_LE(area.y + area.height, 0.95 * height) << text(area) << " of " << text(scene);
  }
}

void expect_nothing_covered(const scene::Scene& scene, const Layout& layout) {
  const image::Area picture{0, 0, scene.film.width, scene.film.height};
  const std::vector<image::Area> areas = all_areas(layout, scene.overlay.view);
  for (std::size_t i = 0; i < areas.size(); ++i) {
    EXPECT_TRUE(inside(areas[i], picture)) << text(areas[i]) << " of " << text(scene);
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_FALSE(overlap(areas[i], areas[j]))
          << text(areas[i]) << " and " << text(areas[j]) << " of " << text(scene);
    }
  }
}

void expect_large_views_and_full_panes(const scene::Scene& scene, const Layout& layout) {
  long long pixels = 0;
  for (const auto& [area, focus, named, heading, thinnest] : all_panes(layout)) {
    EXPECT_TRUE(inside(focus, area)) << text(focus) << " in " << text(area);
    EXPECT_GE(3 * std::min(focus.width, focus.height), std::min(area.width, area.height))
        << text(focus) << " of " << text(scene);
  }
  for (const Layout::Pane& pane : layout.panes) {
    pixels += static_cast<long long>(pane.area.width) * pane.area.height;
  }
  if (scene.overlay.view == scene::View::wrench) {
    EXPECT_EQ(pixels, static_cast<long long>(scene.film.width) * scene.film.height) << text(scene);
  }
}

class LayoutOf : public testing::TestWithParam<std::pair<scene::View, int>> {};

TEST_P(LayoutOf, CoversNothingAndLeavesRoomForWordsAndViews) {
  const auto [view, compared] = GetParam();
  if (has_sanitizers && (view != scene::View::wrench || compared % 4 != 0)) {
    GTEST_SKIP() << "is laid out as one body and four are";
  }
  for_each_layout(view, compared, [](const scene::Scene& scene, const Layout& layout) {
    expect_safe_words_and_insets(scene, layout);
    expect_nothing_covered(scene, layout);
    expect_large_views_and_full_panes(scene, layout);
  });
}

/// Returns each view of one motion, and comparisons of one to four.
std::vector<std::pair<scene::View, int>> views_and_comparisons() {
  std::vector<std::pair<scene::View, int>> all;
  for (const scene::View view : enumerators<scene::View>) all.emplace_back(view, 0);
  for (int compared = 1; compared <= 4; ++compared) all.emplace_back(scene::View::wrench, compared);
  return all;
}

INSTANTIATE_TEST_SUITE_P(All, LayoutOf, testing::ValuesIn(views_and_comparisons()));

TEST(Layout, GivesTheBareBodyTheWholePicture) {
  for (const int width : sides) {
    for (const int height : sides) {
      scene::Scene scene = t_wrench(width, height);
      scene.overlay.show = {scene::Feature::floor, scene::Feature::trail, scene::Feature::momentum};
      const Layout layout = compute_layout(scene);
      ASSERT_EQ(layout.panes.size(), 1U);
      EXPECT_EQ(layout.panes[0].area, (image::Area{0, 0, width, height}));
      EXPECT_EQ(layout.panes[0].focus, (image::Area{0, 0, width, height}));
    }
  }
}

TEST(Layout, DropsInTheStatedOrder) {
  std::size_t before = 6;
  std::set<std::size_t> counts;
  for (int height = 1080; height >= 20; height -= 4) {
    scene::Scene scene = t_wrench(height * 16 / 9, height);
    scene.overlay.show.insert({scene::Feature::poinsot, scene::Feature::components});
    const Layout layout = compute_layout(scene);
    std::vector<bool> kept{layout.title.has_value(), layout.readouts.has_value(),
                           layout.curve.has_value(), layout.components.has_value()};
    for (const auto& inset : layout.insets) kept.push_back(inset.has_value());
    EXPECT_TRUE(std::ranges::is_sorted(kept, std::greater())) << height;
    const auto count = static_cast<std::size_t>(std::ranges::count(kept, true));
    EXPECT_LE(count, before) << "a smaller picture has no more items: " << height;
    before = count;
    counts.insert(count);
  }
  EXPECT_THAT(counts, testing::IsSupersetOf({6U, 4U, 3U, 2U, 0U}));
}

TEST(Layout, ShowsAllOfTheDefaultFilmInFullSizes) {
  for (const auto& [width, height] :
       {std::pair(1920, 1080), {1080, 1920}, {1080, 1080}, {1440, 1080}, {2560, 1080}}) {
    const Layout layout = compute_layout(t_wrench(width, height));
    EXPECT_TRUE(layout.title && layout.readouts && layout.curve && layout.insets[0]) << width;
    EXPECT_FALSE(layout.compact);
    const image::Area& focus = layout.panes[0].focus;
    EXPECT_GE(std::min(focus.width, focus.height), 0.5 * std::min(width, height)) << width;
  }
}

TEST(Layout, LeavesTheBodyOfAWideFilmItsFullHeight) {
  const image::Area focus = compute_layout(t_wrench(1920, 1080)).panes[0].focus;
  EXPECT_EQ(focus.height, 972) << "the height minus margins of 5 %";
  EXPECT_GE(focus.width, 1080);
}

TEST(Layout, GivesAViewOfItsOwnMostOfThePictureAndADescription) {
  for (const auto& [width, height] : {std::pair(1920, 1080), {1080, 1920}, {1080, 1080}}) {
    for (const auto& [view, feature] : scene::insets) {
      scene::Scene scene = t_wrench(width, height);
      scene.overlay.view = view;
      const Layout layout = compute_layout(scene);
      EXPECT_TRUE(layout.description) << width;
      const image::Area focus = layout.insets[scene::inset_index(view)]->focus;
      EXPECT_GE(std::min(focus.width, focus.height), 0.55 * std::min(width, height)) << width;
    }
  }
  EXPECT_FALSE(compute_layout(t_wrench(1920, 1080)).description);
}

TEST(Layout, ReservesTwoLinesForATitleThatIsTooLongForOne) {
  scene::Scene scene = t_wrench(1920, 1080);
  scene.title = "Short";
  const int one = compute_layout(scene).title->height;
  scene.title = "A title that does not fit into the column";
  EXPECT_EQ(compute_layout(scene).title->height, 2 * one);
}

TEST(Layout, ReservesALineForTheMethodOnlyIfItIsShown) {
  scene::Scene scene = t_wrench(1920, 1080);
  const int without = compute_layout(scene).title->height;
  scene.overlay.show.insert(scene::Feature::method);
  EXPECT_GT(compute_layout(scene).title->height, without);
}

TEST(Layout, KeepsTheComponentsOfAComparisonInThreeRows) {
  for (const auto& [width, height] : {std::pair(1920, 1080), {1280, 720}, {1080, 1920}}) {
    scene::Scene scene = t_wrench(width, height);
    scene.overlay.show.erase(scene::Feature::curve);
    scene.overlay.show.insert(scene::Feature::components);
    scene.overlay.compare = {"rk4", "exact"};
    const Layout layout = compute_layout(scene);
    ASSERT_TRUE(layout.components) << width;
    EXPECT_FALSE(is_strip(*layout.components)) << width;
  }
}

TEST(Layout, GivesTheViewsOfALongPictureItsWholeBreadth) {
  for (const auto& [width, height] :
       {std::pair(1600, 300), {3840, 600}, {16384, 164}, {300, 1600}, {200, 1600}}) {
    const Layout layout = compute_layout(t_wrench(width, height));
    EXPECT_TRUE(layout.title && layout.readouts && layout.curve && layout.insets[0]) << width;
    const int breadth = std::min(width, height);
    for (const Layout::Pane& pane : {layout.panes[0], *layout.insets[0]}) {
      EXPECT_GE(std::min(pane.focus.width, pane.focus.height), 0.85 * breadth) << width;
    }
  }
}

TEST(Layout, NamesNothingWhereANameWouldHideIt) {
  EXPECT_TRUE(compute_layout(t_wrench(320, 180)).panes[0].named);
  EXPECT_FALSE(compute_layout(t_wrench(32, 18)).panes[0].named);
}

TEST(Layout, SetsTheWordsOfSmallPicturesNoSmallerThanCanBeRead) {
  EXPECT_TRUE(compute_layout(t_wrench(320, 180)).title);
  EXPECT_TRUE(compute_layout(t_wrench(320, 180)).readouts);
  EXPECT_GE(compute_layout(t_wrench(320, 180)).text.caption, 9);
  EXPECT_DOUBLE_EQ(compute_layout(t_wrench(3840, 2160)).text.title,
                   2 * compute_layout(t_wrench(1920, 1080)).text.title);
}

TEST(Layout, NamesTheBodiesOfAComparisonInAFilmForTelephones) {
  scene::Scene scene = t_wrench();
  scene.film.width = 1080;
  scene.film.height = 1920;
  scene.caption = "A caption.";
  scene.overlay.show = {scene::Feature::omega, scene::Feature::method, scene::Feature::labels};
  scene.overlay.compare_omega = {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}};
  EXPECT_EQ(compute_layout(scene).legends.size(), 3U);
}

TEST(Layout, RefusesAComparisonInAViewOfOneMotion) {
  scene::Scene scene = t_wrench(640, 360);
  scene.overlay.compare = {"rk4", "exact"};
  for (const scene::View view : enumerators<scene::View>) {
    if (view == scene::View::wrench) continue;
    scene.overlay.view = view;
    EXPECT_THROW(compute_layout(scene), InvalidArgument);
  }
}

TEST(Layout, GivesTiltAndMomentsThePlaceOfTheCurve) {
  for (const auto& [width, height] : {std::pair(1920, 1080), {1080, 1920}, {1280, 720}}) {
    scene::Scene scene = t_wrench(width, height);
    const Layout before = compute_layout(scene);
    scene.overlay.show.insert(scene::Feature::tilt);
    Layout layout = compute_layout(scene);
    EXPECT_EQ(layout.tilt, before.curve);
    EXPECT_FALSE(layout.curve || layout.moments);
    EXPECT_EQ(layout.panes[0].focus, before.panes[0].focus);
    scene.overlay.show.insert(scene::Feature::moments);
    layout = compute_layout(scene);
    EXPECT_TRUE(layout.tilt && layout.moments) << width;
    EXPECT_TRUE(inside(*layout.tilt, *before.curve) && inside(*layout.moments, *before.curve));
    scene.overlay.show.erase(scene::Feature::sphere);
    const Layout alone = compute_layout(scene);
    EXPECT_GE(alone.tilt->height, layout.tilt->height) << "also takes the area of the sphere";
  }
}

TEST(Layout, GivesTheLegendOfTheForcesARowBelowTheBody) {
  scene::Scene scene = t_wrench(1280, 720);
  const Layout before = compute_layout(scene);
  scene.overlay.show.insert(scene::Feature::forces);
  const Layout layout = compute_layout(scene);
  ASSERT_TRUE(layout.forces);
  EXPECT_TRUE(inside(*layout.forces, before.panes[0].focus));
  EXPECT_LT(layout.panes[0].focus.y + layout.panes[0].focus.height, layout.forces->y);
}

TEST(Layout, GivesTheBodiesOfAComparisonOneLegendOfTheForces) {
  for (const scene::Feature feature : {scene::Feature::forces, scene::Feature::tip}) {
    for (const bool has_text : {true, false}) {
      scene::Scene scene = t_wrench(1280, 720);
      scene.camera.frame = scene::Frame::rotating;
      if (!has_text) scene.overlay.show.clear();
      scene.overlay.show.insert(feature);
      scene.overlay.compare = {"rk4", "exact"};
      const Layout layout = compute_layout(scene);
      ASSERT_TRUE(layout.forces);
      EXPECT_LE(layout.forces->y + layout.forces->height, 0.95 * 720);
      for (const Layout::Pane& pane : layout.panes) {
        EXPECT_LE(pane.focus.y + pane.focus.height, layout.forces->y);
        EXPECT_GT(pane.focus.height, 300);
      }
    }
  }
}

TEST(Layout, PutsTheGaugeOfTheTorquesBelowTheBody) {
  for (const auto& [width, height] : {std::pair(1920, 1080), {1080, 1920}, {1280, 720}}) {
    scene::Scene scene = t_wrench(width, height);
    scene.camera.frame = scene::Frame::rotating;
    const Layout before = compute_layout(scene);
    scene.overlay.show.insert(scene::Feature::torques);
    const Layout layout = compute_layout(scene);
    ASSERT_TRUE(layout.torques) << width;
    EXPECT_TRUE(inside(*layout.torques, before.panes[0].focus));
    EXPECT_LT(layout.panes[0].focus.y + layout.panes[0].focus.height, layout.torques->y);
  }
}

TEST(Layout, RefusesTorquesAndTheTipOutsideOfTheRotatingFrame) {
  scene::Scene scene = t_wrench(640, 360);
  for (const scene::Feature feature : {scene::Feature::torques, scene::Feature::tip}) {
    scene.overlay.show = {feature};
    for (const scene::Frame frame : {scene::Frame::space, scene::Frame::body}) {
      scene.camera.frame = frame;
      EXPECT_THROW(compute_layout(scene), InvalidArgument);
    }
    scene.camera.frame = scene::Frame::rotating;
    EXPECT_NO_THROW(compute_layout(scene));
  }
}

}  // namespace
}  // namespace twrench::picture
