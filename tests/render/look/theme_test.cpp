#include "render/look/theme.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "render/look/background.h"
#include "render/look/material.h"

namespace twrench::render {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d linear(const scene::Color& color) {
  return {linear_from_srgb(color.red), linear_from_srgb(color.green), linear_from_srgb(color.blue)};
}

/// WCAG 2.1, "relative luminance".
double luminance(const scene::Color& color) {
  return Vector3d(0.2126, 0.7152, 0.0722).dot(linear(color));
}

/// WCAG 2.1, "contrast ratio".
double contrast(const scene::Color& a, const scene::Color& b) {
  const auto [low, high] = std::minmax({luminance(a), luminance(b)});
  return (high + 0.05) / (low + 0.05);
}

/// Linear RGB as perceived with the three kinds of colour vision deficiency, and without. Machado,
/// Oliveira, Fernandes, "A Physiologically-based Model for Simulation of Color Vision Deficiency",
/// IEEE TVCG 15 (2009), severity 1.0.
std::vector<Matrix3d> eyes() {
  Matrix3d protan, deutan, tritan;
  protan << 0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116,
      1.051998;
  deutan << 0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940,
      0.968881;
  tritan << 1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367,
      0.303900;
  return {Matrix3d::Identity(), protan, deutan, tritan};
}

/// CIE L*a*b* (D65) of linear sRGB.
Vector3d lab(const Vector3d& rgb) {
  Matrix3d xyz_from_rgb;
  xyz_from_rgb << 0.4124, 0.3576, 0.1805, 0.2126, 0.7152, 0.0722, 0.0193, 0.1192, 0.9505;
  const Vector3d xyz =
      (xyz_from_rgb * rgb.cwiseMax(0).cwiseMin(1)).cwiseQuotient(Vector3d(0.9505, 1, 1.089));
  const Vector3d f = xyz.unaryExpr(
      [](double t) { return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116; });
  return {116 * f.y() - 16, 500 * (f.x() - f.y()), 200 * (f.y() - f.z())};
}

/// The CIE76 difference for the type of vision that sees the least; 2.3 is just noticeable.
double distance(const scene::Color& a, const scene::Color& b) {
  double least = 1e9;
  for (const Matrix3d& eye : eyes()) {
    least = std::min(least, (lab(eye * linear(a)) - lab(eye * linear(b))).norm());
  }
  return least;
}

/// From the background's darkest to its brightest colour, with the floor's light.
std::vector<scene::Color> grounds(const ThemeStyle& style) {
  const scene::Color& below = style.backdrop.below;
  const scene::Color light = style.floor ? style.floor->light : scene::Color{0, 0, 0};
  return {style.backdrop.above,
          below,
          {std::min(255, below.red + light.red), std::min(255, below.green + light.green),
           std::min(255, below.blue + light.blue)}};
}

/// The panel composited over a background.
scene::Color panel_on(const OverlayColors& colors, const scene::Color& ground) {
  const auto over = [&](int panel, int behind) {
    return static_cast<int>(
        std::lround(colors.panel_opacity * panel + (1 - colors.panel_opacity) * behind));
  };
  return {over(colors.panel.red, ground.red), over(colors.panel.green, ground.green),
          over(colors.panel.blue, ground.blue)};
}

std::vector<scene::Color> telling(const OverlayColors& c) {
  return {c.axis[0], c.axis[1], c.axis[2], c.momentum, c.omega, c.trail, c.plane};
}

class ThemeTest : public testing::TestWithParam<scene::Theme> {
 protected:
  const ThemeStyle& style = style_of(GetParam());
  const OverlayColors& colors = style.overlay;
};

INSTANTIATE_TEST_SUITE_P(Each, ThemeTest,
                         testing::Values(scene::Theme::studio, scene::Theme::paper,
                                         scene::Theme::space));

TEST_P(ThemeTest, HasTextThatCanBeReadAnywhere) {
  for (const scene::Color& ground : grounds(style)) {
    for (const scene::Color& text : {colors.text, colors.dim}) {
      EXPECT_GE(contrast(text, ground), 4.5)
          << scene::to_string(text) << " on " << scene::to_string(ground);
      EXPECT_GE(contrast(text, panel_on(colors, ground)), 4.5);
    }
  }
}

TEST_P(ThemeTest, HasColoursThatCanBeReadOnAPanelAndAwayFromTheLight) {
  for (const scene::Color& color : telling(colors)) {
    for (const scene::Color& ground : grounds(style)) {
      EXPECT_GE(contrast(color, panel_on(colors, ground)), 4.5)
          << scene::to_string(color) << " on a panel on " << scene::to_string(ground);
    }
    EXPECT_GE(contrast(color, style.backdrop.above), 4.5) << scene::to_string(color);
  }
  // Lines: WCAG 2.1, 1.4.11.
  for (const scene::Color& color : colors.curve) {
    for (const scene::Color& ground : grounds(style)) {
      EXPECT_GE(contrast(color, panel_on(colors, ground)), 3) << scene::to_string(color);
    }
  }
}

TEST_P(ThemeTest, HasColoursThatEveryKindOfEyeTellsApart) {
  const auto told = telling(colors);
  for (std::size_t i = 0; i < told.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_GE(distance(told[i], told[j]), 20)
          << scene::to_string(told[i]) << " " << scene::to_string(told[j]);
    }
  }
  for (std::size_t i = 0; i < 9; ++i) {
    for (std::size_t j = i - i % 3; j < i; ++j) {
      EXPECT_GE(distance(colors.curve[i], colors.curve[j]), 18) << "curves " << i << " and " << j;
    }
  }
}

TEST(Contrast, IsThatOfTheStandard) {
  EXPECT_NEAR(contrast({255, 255, 255}, {0, 0, 0}), 21, 1e-9);
  EXPECT_NEAR(contrast({255, 255, 255}, {119, 119, 119}), 4.48, 0.005);
}

}  // namespace
}  // namespace twrench::render
