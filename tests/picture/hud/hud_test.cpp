#include "picture/hud/hud.h"

#include <gmock/gmock.h>

#include <cmath>

#include "base/enumeration.h"
#include "canvas/font.h"
#include "picture/overlay_scene.h"

namespace twrench::picture {
namespace {

constexpr std::pair<int, int> sizes[]{{320, 180},   {640, 360},   {1920, 1080}, {3840, 2160},
                                      {180, 320},   {1080, 1920}, {240, 240},   {1080, 1080},
                                      {1440, 1080}, {2560, 1080}};

Hud hud_of(const OverlayScene& film) {
  return {film.scene, film.timeline.solutions(), film.layout, film.typeface, film.colors};
}

/// WCAG 2.1, "relative luminance", of an sRGB colour of 0 to 1.
double luminance(const std::array<double, 3>& color) {
  const auto linear = [](double c) {
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(color[0]) + 0.7152 * linear(color[1]) + 0.0722 * linear(color[2]);
}

std::array<double, 3> of(const Color& color) {
  return {color.red / 255.0, color.green / 255.0, color.blue / 255.0};
}

double contrast_of(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  const double one = luminance(a) + 0.05, other = luminance(b) + 0.05;
  return std::max(one, other) / std::min(one, other);
}

TEST(Hud, KeepsItsWordsInItsAreasAtEverySize) {
  for (const auto& [width, height] : sizes) {
    for (const std::string title :
         {"A", "The Dzhanibekov effect",
          "A title so long that it would run through the whole picture "
          "and out of it again, were it not made smaller and shortened"}) {
      const OverlayScene film(film_of(width, height, title));
      for (const image::Area& area : hud_of(film).extents()) {
        EXPECT_GE(area.x, 0.05 * width);
        EXPECT_GE(area.y, 0.05 * height);
        EXPECT_LE(area.x + area.width, 0.95 * width + 1) << width << "x" << height;
        EXPECT_LE(area.y + area.height, 0.95 * height + 1) << width << "x" << height;
      }
    }
  }
}

TEST(Hud, HasRoomForLongNamesInEveryPane) {
  for (const auto& [width, height] : sizes) {
    for (std::size_t count = 2; count <= 4; ++count) {
      scene::Scene scene = film_of(width, height);
      scene.overlay.compare.assign(count, "implicit-trapezoid");
      scene.motion.duration = 1;
      const OverlayScene film(scene);
      const std::vector<image::Area> extents = hud_of(film).extents();
      for (std::size_t i = 0; i < film.layout.legends.size(); ++i) {
        const image::Area& legend = film.layout.legends[i];
        const image::Area& extent = extents[extents.size() - film.layout.legends.size() + i];
        EXPECT_LE(extent.width, legend.width + 1) << width << "x" << height << " " << count;
        EXPECT_LE(extent.height, legend.height + 2) << width << "x" << height << " " << count;
      }
    }
  }
}

TEST(Hud, ShowsEachMethodsDriftInTheSmallestPanes) {
  for (const auto& [width, height] : {std::pair(320, 180), {180, 320}}) {
    for (const std::size_t count : {2U, 3U}) {
      scene::Scene scene = film_of(width, height);
      scene.overlay.compare.assign(count, "exact");
      scene.motion.duration = 1;
      const OverlayScene film(scene);
      Hud hud = hud_of(film);
      ASSERT_EQ(film.layout.legends.size(), count);
      timeline::FrameState state = film.timeline.frame_state(0);
      const auto before = hud.draw(state);
      state.solutions[1].diagnostics.energy_drift = 0.5;
      EXPECT_FALSE(same(hud.draw(state), before)) << width << "x" << height << " " << count;
    }
  }
}

TEST(Hud, DrawsTheSameWhateverItDrewBefore) {
  const OverlayScene film(film_of(640, 360));
  Hud hud = hud_of(film);
  timeline::FrameState state = film.timeline.frame_state(0);
  const auto first = hud.draw(state);
  state.solutions[0].sample.t = 42.5;
  state.solutions[0].diagnostics.energy_drift = -1.2e-15;
  const auto later = hud.draw(state);
  EXPECT_FALSE(same(first, later));
  EXPECT_TRUE(same(hud.draw(film.timeline.frame_state(0)), first));
}

TEST(Hud, HoldsWhateverTheNumbers) {
  const OverlayScene film(film_of(320, 180));
  Hud hud = hud_of(film);
  for (const double drift : {0.0, -1.2e-15, 1e300, -9.99e-300}) {
    timeline::FrameState state = film.timeline.frame_state(0);
    state.solutions[0].diagnostics.energy_drift = drift;
    state.solutions[0].next_flip.reset();
    for (const Layer& layer : hud.draw(state)) {
      EXPECT_GE(layer.x, 0);
      EXPECT_LE(layer.x + layer.image.width, 320);
      EXPECT_LE(layer.y + layer.image.height, 180);
    }
  }
}

TEST(Hud, SaysNothingOfFlipsWhereThereAreNone) {
  scene::Scene steady = film_of(1920, 1080);
  steady.motion.omega = {0, 0, 1};
  for (const bool flips : {true, false}) {
    const OverlayScene film(flips ? film_of(1920, 1080) : steady);
    Hud hud = hud_of(film);
    timeline::FrameState state = film.timeline.frame_state(0);
    const auto before = hud.draw(state);
    state.solutions[0].flips = 7;
    state.solutions[0].next_flip = 77;
    EXPECT_NE(same(hud.draw(state), before), flips);
  }
}

TEST(Hud, ShowsMethodAndDriftOnlyIfAsked) {
  scene::Scene scene = film_of(1920, 1080);
  const OverlayScene plain(scene);
  scene.overlay.show.insert(scene::Feature::drift);
  const OverlayScene with_drift(scene);
  scene.overlay.show.insert(scene::Feature::method);
  const OverlayScene with_both(scene);
  EXPECT_GT(hud_of(with_both).extents()[0].height, hud_of(with_drift).extents()[0].height);
  for (const OverlayScene* film : {&plain, &with_drift}) {
    Hud hud = hud_of(*film);
    timeline::FrameState state = film->timeline.frame_state(0);
    const auto before = hud.draw(state);
    state.solutions[0].diagnostics.energy_drift = 0.5;
    EXPECT_EQ(same(hud.draw(state), before), film == &plain);
  }
}

TEST(Hud, RemarksWhatHappensInEachPane) {
  scene::Scene scene = film_of(1920, 1080);
  for (const std::size_t count : {0U, 2U, 3U, 4U}) {
    scene.overlay.compare.assign(count, "exact");
    const OverlayScene film(scene);
    Hud hud = hud_of(film);
    for (std::size_t i = 0; i < std::max<std::size_t>(count, 1); ++i) {
      timeline::FrameState state = film.timeline.frame_state(0);
      // The readouts of a comparison show it too; there it changes no digit.
      state.solutions[i].diagnostics.orthogonality_error = 0.00996;
      const auto before = hud.draw(state);
      state.solutions[i].diagnostics.orthogonality_error = 0.01001;
      EXPECT_FALSE(same(hud.draw(state), before)) << count << " " << i;
    }
  }
}

TEST(Hud, BreaksALongTitleInsteadOfShrinkingIt) {
  const OverlayScene one(film_of(1920, 1080, "The Dzhanibekov"));
  const OverlayScene two(film_of(1920, 1080, "The Dzhanibekov effect of a wrench"));
  const image::Area short_title = hud_of(one).extents()[0], long_title = hud_of(two).extents()[0];
  EXPECT_NEAR(long_title.height, 2 * short_title.height, 2);
  EXPECT_LE(long_title.width, two.layout.title->width);
}

TEST(Hud, DescribesAViewOfItsOwn) {
  scene::Scene scene = film_of(1920, 1080);
  for (const auto& [view, feature] : scene::insets) {
    scene.overlay.view = view;
    const OverlayScene film(scene);
    const std::vector<image::Area> extents = hud_of(film).extents();
    ASSERT_EQ(extents.size(), 3U);
    EXPECT_GE(extents[2].height, 4 * film.layout.text.readout) << "several lines";
    EXPECT_LE(extents[2].height, film.layout.description->height);
    EXPECT_LE(extents[2].width, film.layout.description->width + 1);
  }
}

TEST(Hud, CanBeReadOnWhateverLiesBelow) {
  for (const scene::Theme theme : enumerators<scene::Theme>) {
    const OverlayColors& colors = style_of(theme).overlay;
    for (const double below : {0.0, 0.5, 1.0}) {
      std::array<double, 3> ground = of(colors.panel);
      for (double& c : ground) c = c * colors.panel_opacity + below * (1 - colors.panel_opacity);
      EXPECT_GE(contrast_of(of(colors.text), ground), 4.5) << below;
      EXPECT_GE(contrast_of(of(colors.dim), ground), 4.5) << below;
    }
  }
}

/// Returns the alpha of a pixel of the picture.
int alpha_at(const Layer& layer, int x, int y) {
  return layer.image.pixels[static_cast<std::size_t>(y - layer.y) * layer.image.row_bytes() +
                            4 * static_cast<std::size_t>(x - layer.x) + 3];
}

TEST(Hud, LaysAPanelUnderAllItsWordsOnABackgroundOfAnotherColour) {
  for (const bool transparent : {false, true}) {
    scene::Scene scene = film_of(1920, 1080);
    scene.look.transparent = transparent;
    if (!transparent) scene.look.background = Color{255, 255, 255};
    const OverlayScene film(scene);
    Hud hud = hud_of(film);
    const auto layers = hud.draw(film.timeline.frame_state(0));
    const auto extents = hud.extents();
    ASSERT_EQ(layers.size(), extents.size());
    const int least = static_cast<int>(255 * film.colors.panel_opacity);
    // Each side has a margin of 0.4 em; the corners are rounded.
    const int margin = static_cast<int>(0.4 * film.layout.text.caption);
    ASSERT_GE(margin, 4);
    for (std::size_t i = 0; i < layers.size(); ++i) {
      const image::Area& text = extents[i];
      for (int y = text.y; y < text.y + text.height; ++y) {
        for (int x = text.x - margin; x < text.x + text.width + margin; ++x) {
          ASSERT_GE(alpha_at(layers[i], x, y), least) << x << " " << y;
        }
      }
      for (int x = text.x; x < text.x + text.width; ++x) {
        ASSERT_GE(alpha_at(layers[i], x, text.y - margin), least) << x;
        ASSERT_GE(alpha_at(layers[i], x, text.y + text.height - 1 + margin), least) << x;
      }
    }
  }
}

/// Returns the HUD of a picture of another size with the same motions.
Hud hud_in(OverlayScene& film, int width, int height) {
  film.scene.film.width = width;
  film.scene.film.height = height;
  film.layout = compute_layout(film.scene);
  return hud_of(film);
}

std::vector<image::Area> places_of_words(const Layout& layout) {
  std::vector<image::Area> places;
  if (layout.title) places.push_back(*layout.title);
  if (layout.readouts) places.push_back(*layout.readouts);
  places.insert(places.end(), layout.legends.begin(), layout.legends.end());
  for (const auto& pane : layout.insets) {
    if (pane && pane->heading) places.push_back(*pane->heading);
  }
  return places;
}

TEST(Hud, KeepsItsWordsInTheirPlacesInPicturesOfAnyShape) {
  const std::string titles[]{"A", "A\u0301\u0302", "Вращение твёрдого тела, долгое", ""};
  for (const std::size_t compared : {0U, 2U, 4U}) {
    scene::Scene scene = film_of(1920, 1080);
    scene.motion.duration = 1;
    scene.overlay.compare.assign(compared, "implicit-trapezoid");
    for (const auto& [font, language] :
         {std::pair("sans", scene::Language::en), {"mono", scene::Language::nb}}) {
      scene.overlay.font = font;
      scene.language = language;
      OverlayScene film(scene);
      for (const int width : {16, 48, 72, 100, 164, 300, 728, 1600, 4000}) {
        for (const int height : {16, 48, 72, 100, 164, 300, 728, 1600}) {
          film.scene.title = titles[static_cast<std::size_t>(width + height) % std::size(titles)];
          Hud hud = hud_in(film, width, height);
          const std::vector<image::Area> extents = hud.extents();
          const std::vector<image::Area> places = places_of_words(film.layout);
          ASSERT_EQ(extents.size(), places.size());
          for (std::size_t i = 0; i < places.size(); ++i) {
            EXPECT_EQ(image::common(extents[i], places[i]).width, extents[i].width)
                << font << " " << width << "x" << height << " " << i;
            EXPECT_LE(extents[i].height, places[i].height + 2) << width << "x" << height;
          }
          for (const Layer& layer : hud.draw(film.timeline.frame_state(0))) {
            EXPECT_EQ(image::common(layer.area(), {0, 0, width, height}), layer.area());
          }
        }
      }
    }
  }
}

TEST(Hud, LaysNoPanelWhereNoWordHasRoom) {
  OverlayScene film(film_of(640, 360));
  film.layout.title = image::Area{40, 40, 4, 4};
  film.layout.readouts = image::Area{40, 80, 4, 4};
  film.layout.insets = {};
  Hud hud = hud_of(film);
  EXPECT_TRUE(hud.draw(film.timeline.frame_state(0)).empty());
}

std::string refusal_of(const scene::Scene& scene) {
  try {
    hud_of(OverlayScene(scene));
  } catch (const canvas::MissingGlyph& error) {
    return error.what();
  }
  return "none";
}

TEST(Hud, NamesATitlesCharacterThatNoFontHas) {
  const auto refusal_for = [](const std::string& character) {
    return "title: contains the character " + character +
           ", which neither the font nor the built-in sans can draw";
  };
  scene::Scene scene = film_of(640, 360, "Flip \xEE\x84\xA3");
  EXPECT_EQ(refusal_of(scene), refusal_for("U+E123"));
  scene.title = "e\u0301 \u0628";
  EXPECT_EQ(refusal_of(scene), refusal_for("U+0628"));
  scene.title = "";
  scene.name = "\u65E5\u672C";
  EXPECT_EQ(refusal_of(scene), refusal_for("U+65E5"))
      << "the scene's name replaces a missing title";
}

TEST(Hud, TakesTitlesOfManyTongues) {
  for (const char* title : {"Эффект Джанибекова", "Théorème de la raquette", "The\u0301ore\u0300me",
                            "V\u1EADn to\u0302\u0301c", "ω × L", "a\xFF", ""}) {
    const OverlayScene film(film_of(640, 360, title));
    EXPECT_NO_THROW(hud_of(film)) << title;
  }
}

}  // namespace
}  // namespace twrench::picture
