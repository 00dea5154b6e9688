#include "picture/look/emphasis.h"

#include <gtest/gtest.h>

namespace twrench::picture {
namespace {

using scene::Feature;

TEST(Emphasis, DimsTheColorsOfAllOtherFeatures) {
  const OverlayColors usual = style_of(scene::Theme::studio).overlay;
  const auto is_as_usual = [&](const Color& color, const Color& before) {
    EXPECT_TRUE(color == before || color == dimmed(before, usual));
    return color == before;
  };
  for (const Feature stressed : {Feature::axes, Feature::momentum, Feature::omega, Feature::trail,
                                 Feature::plane, Feature::hud}) {
    scene::Overlay overlay;
    overlay.stress = {stressed};
    const OverlayColors colors = emphasised(usual, overlay);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(is_as_usual(colors.axis[i], usual.axis[i]), stressed == Feature::axes);
    }
    EXPECT_EQ(is_as_usual(colors.momentum, usual.momentum), stressed == Feature::momentum);
    EXPECT_EQ(is_as_usual(colors.omega, usual.omega), stressed == Feature::omega);
    EXPECT_EQ(is_as_usual(colors.trail, usual.trail), stressed == Feature::trail);
    EXPECT_EQ(is_as_usual(colors.plane, usual.plane), stressed == Feature::plane);
    EXPECT_EQ(colors.text, usual.text);
  }
  const OverlayColors colors = emphasised(usual, {});
  EXPECT_TRUE(is_as_usual(colors.momentum, usual.momentum)) << "nothing is stressed";
}

}  // namespace
}  // namespace twrench::picture
