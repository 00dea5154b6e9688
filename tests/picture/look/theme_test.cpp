#include "picture/look/theme.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "base/enumeration.h"
#include "picture/color_vision.h"

namespace twrench::picture {
namespace {

/// From the theme's darkest to its brightest background, with the floor's light.
std::vector<Color> own_grounds(const ThemeStyle& style) {
  const Color& below = style.backdrop.below;
  const Color light = style.floor ? style.floor->light : Color{0, 0, 0};
  return {style.backdrop.above,
          below,
          {std::min(255, below.red + light.red), std::min(255, below.green + light.green),
           std::min(255, below.blue + light.blue)}};
}

/// Also with backgrounds that a user may choose or composite a transparent video over.
std::vector<Color> any_ground(const ThemeStyle& style) {
  std::vector<Color> grounds = own_grounds(style);
  grounds.insert(grounds.end(),
                 {{255, 255, 255}, {0, 0, 0}, {128, 128, 128}, {138, 43, 226}, {255, 255, 0}});
  return grounds;
}

/// Returns the panel composited over a background.
Color panel_on(const OverlayColors& colors, const Color& ground) {
  const auto over = [&](int panel, int behind) {
    return static_cast<int>(
        std::lround(colors.panel_opacity * panel + (1 - colors.panel_opacity) * behind));
  };
  return {over(colors.panel.red, ground.red), over(colors.panel.green, ground.green),
          over(colors.panel.blue, ground.blue)};
}

/// Returns the colours of the overlays with a name or a trail.
std::vector<Color> named(const OverlayColors& c) {
  return {c.axis[0], c.axis[1], c.axis[2], c.momentum, c.omega, c.trail};
}

/// Returns the colours of the overlays about the body, which must be distinguishable. A new colour
/// of OverlayColors must be among them or be named here.
std::vector<Color> told_apart(const OverlayColors& colors) {
  const auto& [text, dim, panel, panel_opacity, axis, momentum, omega, force, trail, plane, curve] =
      colors;
  return {axis[0], axis[1], axis[2], momentum, omega, trail, plane};
}

/// The colours of the overlays that show forces.
std::vector<Color> beside_forces(const OverlayColors& colors) {
  const auto& force = colors.force;
  return {force[0], force[1], force[2], colors.momentum, colors.trail};
}

class ThemeTest : public testing::TestWithParam<scene::Theme> {
 protected:
  const ThemeStyle& style = style_of(GetParam());
  const OverlayColors& colors = style.overlay;
};

INSTANTIATE_TEST_SUITE_P(Each, ThemeTest, testing::ValuesIn(enumerators<scene::Theme>),
                         [](const auto& theme) {
                           return std::string(enumerator_name(theme.param));
                         });

TEST_P(ThemeTest, HasTextThatCanBeReadOnAPanelOverAnything) {
  for (const Color& ground : own_grounds(style)) {
    for (const Color& text : {colors.text, colors.dim}) {
      EXPECT_GE(contrast(text, ground), 4.5) << to_string(text) << " on " << to_string(ground);
    }
  }
  std::vector<Color> texts = named(colors);
  texts.insert(texts.end(), {colors.text, colors.dim});
  texts.insert(texts.end(), colors.curve.begin(), colors.curve.end());  // their names
  texts.insert(texts.end(), colors.force.begin(), colors.force.end());
  for (const Color& ground : any_ground(style)) {
    for (const Color& text : texts) {
      EXPECT_GE(contrast(text, panel_on(colors, ground)), 4.5)
          << to_string(text) << " on a panel on " << to_string(ground);
    }
  }
}

TEST_P(ThemeTest, HasColoursThatEveryKindOfEyeTellsApart) {
  const std::vector<Color> told = told_apart(colors);
  for (std::size_t i = 0; i < told.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_GE(distance(told[i], told[j]), 20) << to_string(told[i]) << " " << to_string(told[j]);
    }
  }
  for (std::size_t i = 0; i < 9; ++i) {
    for (std::size_t j = i - i % 3; j < i; ++j) {
      EXPECT_GE(distance(colors.curve[i], colors.curve[j]), 20) << "curves " << i << " and " << j;
    }
  }
}

// No force has the colour of an axis, even in another picture.
TEST_P(ThemeTest, HasColoursOfForcesThatAreNotThoseOfAxes) {
  const std::vector<Color> told = beside_forces(colors);
  for (std::size_t i = 0; i < told.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_GE(distance(told[i], told[j]), 20) << to_string(told[i]) << " " << to_string(told[j]);
    }
  }
  for (const Color& force : colors.force) {
    for (const Color& axis : colors.axis) {
      EXPECT_GE((lab(linear(force)) - lab(linear(axis))).norm(), 30)
          << to_string(force) << " " << to_string(axis);
    }
  }
}

// The shader divides by the distance and the size of each light.
TEST_P(ThemeTest, HasAPlaceAndASizeForEachLight) {
  for (const AreaLight& light : style.studio.lights) {
    EXPECT_GT(glm::length(light.centre), 0);
    EXPECT_GT(glm::length(glm::cross(light.across, light.along)), 0);
  }
}

TEST_P(ThemeTest, HasTextThatCanBeReadOnAWebPage) {
  const PageColors& page = style.page;
  for (const Color& ground : {page.ground, page.panel, page.raised}) {
    for (const Color& text : {colors.text, page.dim, page.warning}) {
      EXPECT_GE(contrast(text, ground), 4.5) << to_string(text) << " on " << to_string(ground);
    }
  }
  EXPECT_GE(contrast(page.on_momentum, colors.momentum), 4.5);
}

TEST(Contrast, IsThatOfTheStandard) {
  EXPECT_NEAR(contrast({255, 255, 255}, {0, 0, 0}), 21, 1e-9);
  EXPECT_NEAR(contrast({255, 255, 255}, {119, 119, 119}), 4.48, 0.005);
}

}  // namespace
}  // namespace twrench::picture
