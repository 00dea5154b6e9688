#include "picture/hud/caption.h"

#include <gtest/gtest.h>
#include <twrench/base/error.h>

#include <cmath>
#include <sstream>

#include "base/enumeration.h"
#include "canvas/font.h"
#include "canvas/typesetting.h"
#include "picture/overlay_scene.h"

namespace twrench::picture {
namespace {

const canvas::Typeface& sans() {
  static const canvas::Typeface typeface = canvas::load_typeface("sans");
  return typeface;
}

const std::string sentence =
    "The angular momentum never moves, and the angular velocity wanders about it.";

scene::Scene captioned(int width, int height, const std::string& text = sentence) {
  scene::Scene scene = film_of(width, height);
  scene.caption = text;
  return scene;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : " ") + line;
  return text;
}

TEST(Caption, IsBrokenIntoFewLinesOfAboutTheSameLength) {
  const canvas::Font& font = sans().regular;
  const double whole = canvas::typeset(font, sentence).width;
  for (const auto& [width, count] :
       {std::pair(whole + 0.1, 1U), {0.6 * whole, 2U}, {0.4 * whole, 3U}}) {
    const auto lines = broken_into_lines(font, sentence, width, 3);
    ASSERT_TRUE(lines) << width;
    EXPECT_EQ(lines->size(), count);
    EXPECT_EQ(joined(*lines), sentence);
    for (const std::string& line : *lines) {
      const double length = canvas::typeset(font, line).width;
      EXPECT_LE(length, width);
      EXPECT_NEAR(length, whole / count, 0.2 * whole / count) << line;
    }
  }
  EXPECT_EQ(broken_into_lines(font, "It spins. And then it turns over", 12, 2),
            (std::vector<std::string>{"It spins.", "And then it turns over"}))
      << "between the sentences";
  EXPECT_FALSE(broken_into_lines(font, sentence, 0.4 * whole, 2)) << "too many";
  EXPECT_FALSE(broken_into_lines(font, "a unbreakableunbreakable", 4, 3)) << "too wide a word";
  EXPECT_EQ(broken_into_lines(font, " one\n two ", 20, 2), std::vector<std::string>{"one two"});
  EXPECT_TRUE(broken_into_lines(font, "", 20, 2)->empty());
}

TEST(Caption, HasRoomThatNothingElseTakes) {
  for (const auto& [width, height] :
       {std::pair(1280, 720), {720, 1280}, {800, 800}, {1600, 300}, {300, 1600}, {320, 180}}) {
    for (const scene::View view : {scene::View::wrench, scene::View::quad, scene::View::momentum}) {
      scene::Scene scene = captioned(width, height);
      scene.overlay.view = view;
      const Layout layout = compute_layout(scene);
      ASSERT_TRUE(layout.caption) << width << "x" << height;
      const image::Area& area = layout.caption->area;
      EXPECT_EQ(image::common(area, {0, 0, width, height}), area);
      const auto expect_apart = [&](const std::optional<image::Area>& other) {
        if (!other) return;
        const image::Area both = image::common(area, *other);
        EXPECT_TRUE(both.width <= 0 || both.height <= 0) << width << "x" << height;
      };
      expect_apart(layout.title);
      expect_apart(layout.readouts);
      expect_apart(layout.components);
      for (const auto& pane : layout.panes) expect_apart(pane.focus);
      for (const auto& inset : layout.insets) {
        if (inset) expect_apart(inset->focus);
      }
    }
  }
  EXPECT_FALSE(compute_layout(film_of(1280, 720)).caption) << "without a caption";
  EXPECT_FALSE(compute_layout(captioned(160, 90)).caption) << "too small to be read";
}

TEST(Caption, OfTheBuiltInStoriesFitsPicturesOfAnyShape) {
  for (const char* name : {"explain", "explain-nb"}) {
    for (scene::Shot& shot : scene::load_scene(name).shots) {
      for (const auto& [width, height] :
           {std::pair(1280, 720), {720, 1280}, {800, 800}, {1000, 800}, {800, 1000}, {2400, 400}}) {
        shot.scene.film.width = width;
        shot.scene.film.height = height;
        const auto place = compute_layout(shot.scene).caption.value();
        EXPECT_TRUE(broken_into_lines(sans().regular, *shot.scene.caption, place.line_width(),
                                      place.most_lines))
            << width << "x" << height << ": " << *shot.scene.caption;
      }
    }
  }
}

// Applications for telephones lay their buttons over the lowest fifth of a film.
TEST(Caption, IsAboveTheButtonsOfATelephone) {
  for (const auto& [width, height] : {std::pair(1080, 1920), {540, 960}, {800, 1200}}) {
    const Layout layout = compute_layout(captioned(width, height));
    const image::Area& area = layout.caption.value().area;
    EXPECT_LE(area.y + area.height, 0.8 * height + 1) << width;
    EXPECT_GE(area.y + area.height, 0.78 * height) << width;
  }
  const Layout wide = compute_layout(captioned(1200, 1080));
  EXPECT_GT(wide.caption.value().area.y + wide.caption.value().area.height, 0.94 * 1080);
}

TEST(Caption, HasCapitalsAsHighAsA25thOfThePicture) {
  const Layout layout = compute_layout(captioned(1280, 720));
  EXPECT_GE(layout.caption->size * sans().regular.cap_height(), 720 / 25.0);
}

TEST(Caption, IsDrawnInItsRoomAsStronglyAsItIsTold) {
  for (const scene::Theme theme : enumerators<scene::Theme>) {
    scene::Scene scene = captioned(640, 360);
    scene.look.theme = theme;
    const OverlayScene with(scene);
    Caption caption(sentence, *with.layout.caption, with.typeface, with.colors);
    timeline::FrameState state = with.timeline.frame_state(0);
    const auto full = caption.draw(state);
    ASSERT_EQ(full.size(), 1u);
    EXPECT_EQ(full[0].area(), with.layout.caption->area);
    state.caption_opacity = 0.5;
    const auto half = caption.draw(state);
    ASSERT_EQ(half.size(), 1u);
    for (std::size_t i = 0; i < full[0].image.pixels.size(); ++i) {
      EXPECT_NEAR(half[0].image.pixels[i], full[0].image.pixels[i] / 2.0, 0.5 + 1e-9);
    }
    state.caption_opacity = 0;
    EXPECT_TRUE(caption.draw(state).empty());
  }
}

TEST(Caption, ThatCannotBeSetIsRefused) {
  const OverlayScene with(captioned(640, 360));
  const auto set = [&](const std::string& text) {
    return Caption(text, *with.layout.caption, with.typeface, with.colors);
  };
  EXPECT_NO_THROW(set(sentence));
  EXPECT_NO_THROW(set(""));
  EXPECT_THROW(set(sentence + sentence), InvalidArgument);
  EXPECT_THROW(set("a \U0001F600 b"), canvas::MissingGlyph);
}

}  // namespace
}  // namespace twrench::picture
