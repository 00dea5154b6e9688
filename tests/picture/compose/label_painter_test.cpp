#include "picture/compose/label_painter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "canvas/font.h"
#include "picture/compose/letters.h"

namespace twrench::picture {
namespace {

using Eigen::Vector2d;

constexpr double em = 24;
const Color yellow{255, 216, 39}, pink{247, 120, 201};
const image::Area whole_picture{0, 0, 640, 360};
const Vector2d arrow_start(200, 180);

/// Returns two labels: L to the right, and omega, which is shorter, at that angle in rad above it.
std::vector<Label> labels_at(double angle) {
  const Vector2d way(std::cos(angle), -std::sin(angle));
  return {{"L", {520, 180}, {1, 0}, yellow, arrow_start},
          {"ω", arrow_start + 240 * way, way, pink, arrow_start}};
}

class LabelPainterTest : public testing::Test {
 protected:
  canvas::Typeface typeface = canvas::load_typeface("sans");
  LabelPainter painter{typeface.regular, em, {14, 16, 21}, whole_picture, {}};

  /// Returns the area of the letters.
  static image::Area area_of_letters(const Layer& layer, const Color& ink) {
    Vector2d low = Vector2d::Constant(1 << 20), high = -low;
    for (const Vector2d& pixel : letters(layer, ink)) {
      low = low.cwiseMin(pixel);
      high = high.cwiseMax(pixel);
    }
    const Eigen::Vector2i first = low.cast<int>(), size = (high - low).cast<int>();
    return {first.x(), first.y(), size.x() + 1, size.y() + 1};
  }
};

TEST_F(LabelPainterTest, PutsALabelBeyondTheEndOfItsObject) {
  const auto layers = painter.paint(labels_at(0.5));
  const image::Area letter = area_of_letters(layers[1], pink);
  const Vector2d tip = labels_at(0.5)[1].anchor;
  EXPECT_NEAR(letter.x + letter.width / 2.0, tip.x() + 0.5 * em, 0.5 * em);
  EXPECT_LT(letter.y + letter.height, tip.y()) << "above";
}

TEST_F(LabelPainterTest, KeepsALabelOffAnArrowThatItsOwnNearlyAlignsWith) {
  for (double angle = -0.2; angle <= 0.2; angle += 0.002) {
    if (angle > -0.08 && angle < -0.055) continue;  // where it crosses
    const image::Area letter = area_of_letters(painter.paint(labels_at(angle))[1], pink);
    const bool above = letter.y + letter.height<180 - 0.2 * em, below = letter.y> 180 + 0.2 * em;
    EXPECT_TRUE(above || below) << angle;
    if (angle > -0.055) {
      EXPECT_TRUE(above) << angle << ": it does not change sides while it is near";
    }
  }
}

TEST_F(LabelPainterTest, KeepsALabelOffTheHeadOfALargeArrow) {
  std::vector<Label> labels = labels_at(0);
  labels[0].half_width = 2 * em;
  const image::Area letter = area_of_letters(painter.paint(labels)[1], pink);
  EXPECT_LE(letter.y + letter.height, 180 - 2 * em);
}

TEST_F(LabelPainterTest, MovesLabelsContinuously) {
  const auto height = [&](double angle) {
    const Layer layer = painter.paint(labels_at(angle))[1];
    double sum = 0, count = 0;
    for (int y = 0; y < layer.image.height; ++y) {
      for (int x = 0; x < layer.image.width; ++x) {
        if (!is_ink(layer, x, y, pink)) continue;
        sum += layer.y + y;
        ++count;
      }
    }
    return sum / count;
  };
  double before = height(-0.3);
  for (double angle = -0.3; angle <= 0.3; angle += 0.0005) {
    const double now = height(angle);
    EXPECT_LE(std::abs(now - before), 3) << angle;
    before = now;
  }
}

// The label is blank and as wide as a digit. It is placed like a letter, and all ink is the
// leader's, regardless of the font and of how FreeType and Cairo draw it.
TEST_F(LabelPainterTest, LeadsToALabelThatWasMoved) {
  const auto leader_at = [&](double angle) {
    auto labels = labels_at(angle);
    labels[1].text = "\u2007";
    const Layer layer = painter.paint(labels)[1];
    std::vector<int> rows;
    for (int y = 0; y < layer.image.height; ++y) {
      for (int x = 0; x < layer.image.width; ++x) {
        if (layer.image.pixels[static_cast<std::size_t>(4 * (y * layer.image.width + x) + 3)] > 0)
          rows.push_back(layer.y + y);
      }
    }
    return rows;
  };
  EXPECT_TRUE(leader_at(0.5).empty()) << "it was not moved";
  const std::vector<int> rows = leader_at(0);
  ASSERT_FALSE(rows.empty());
  EXPECT_NEAR(rows.back(), arrow_start.y(), 0.25 * em) << "from the tip of the arrow";
  EXPECT_GT(rows.back() - rows.front(), 0.2 * em) << "up to the label";
}

TEST_F(LabelPainterTest, StaysInThePictureAndOutOfWhatIsTaken) {
  const LabelPainter full(typeface.regular, em, {14, 16, 21}, whole_picture, {{500, 0, 140, 360}});
  const Layer layer = full.paint({{"L", {505, 180}, {1, 0}, yellow, arrow_start}})[0];
  EXPECT_LE(layer.x + layer.image.width, 501 + 8) << "its leader may end at the tip";
  const image::Area letter = area_of_letters(layer, yellow);
  EXPECT_LE(letter.x + letter.width, 500);
}

}  // namespace
}  // namespace twrench::picture
