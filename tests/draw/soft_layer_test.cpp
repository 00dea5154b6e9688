#include "draw/soft_layer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace twrench::draw {
namespace {

using Cell = SoftLayer::Cell;

image::Image gray(int width, int height, std::uint8_t level) {
  image::Image image(width, height, 3);
  std::ranges::fill(image.pixels, level);
  return image;
}

/// A picture with every level beside every other.
image::Image noise(int width, int height) {
  image::Image image(width, height, 3);
  std::mt19937 random(1);
  for (std::uint8_t& value : image.pixels) value = static_cast<std::uint8_t>(random() % 256);
  return image;
}

/// Returns a layer of cells that fills the picture except for a margin of fractional width.
SoftLayer over(const image::Image& image, int columns, int rows, std::vector<Cell> cells) {
  SoftLayer layer{columns, rows, std::move(cells), {1.5, 2.25}, {1, 1}, {}};
  layer.covered = {2, 3, image.width - 5, image.height - 6};
  layer.cell_size = {(image.width - 4.0) / columns, (image.height - 5.0) / rows};
  return layer;
}

/// Returns cells of random colours that are no brighter than their alpha.
std::vector<Cell> random_cells(int count) {
  std::mt19937 random(2);
  std::uniform_real_distribution<float> share(0, 1);
  std::vector<Cell> cells;
  for (int i = 0; i < count; ++i) {
    const float alpha = 255 * share(random);
    cells.emplace_back(alpha * share(random), alpha * share(random), alpha * share(random), alpha);
  }
  return cells;
}

/// Returns the colour of the layer at the centre of a pixel, by the definition of bilinear
/// interpolation.
Eigen::Array4d interpolated(const SoftLayer& layer, int x, int y) {
  const double column = std::clamp((x + 0.5 - layer.corner.x()) / layer.cell_size.x() - 0.5, 0.0,
                                   layer.columns - 1.0);
  const double row =
      std::clamp((y + 0.5 - layer.corner.y()) / layer.cell_size.y() - 0.5, 0.0, layer.rows - 1.0);
  Eigen::Array4d sum = Eigen::Array4d::Zero();
  for (int r = 0; r < layer.rows; ++r) {
    for (int c = 0; c < layer.columns; ++c) {
      const double weight =
          std::max(0.0, 1 - std::abs(column - c)) * std::max(0.0, 1 - std::abs(row - r));
      sum += weight * layer.cells[static_cast<std::size_t>(r * layer.columns + c)].cast<double>();
    }
  }
  return sum;
}

std::uint8_t value(const image::Image& image, int x, int y, int channel) {
  return image.pixels[static_cast<std::size_t>((y * image.width + x) * 3 + channel)];
}

// Rounding contributes half a level, dither three eighths.
TEST(SoftLayer, InterpolatesBetweenTheCentresOfCells) {
  const image::Image before = noise(67, 41);
  const SoftLayer layer = over(before, 7, 5, random_cells(35));
  image::Image after = before;
  composite_over(after, layer);
  for (int y = 0; y < before.height; ++y) {
    for (int x = 0; x < before.width; ++x) {
      const image::Area& in = layer.covered;
      const bool is_covered = x >= in.x && x < in.x + in.width && y >= in.y && y < in.y + in.height;
      const Eigen::Array4d color =
          is_covered ? interpolated(layer, x, y) : Eigen::Array4d(Eigen::Array4d::Zero());
      for (int c = 0; c < 3; ++c) {
        const double expected = color[c] + value(before, x, y, c) * (1 - color[3] / 255);
        ASSERT_NEAR(value(after, x, y, c), expected, is_covered ? 0.95 : 0) << x << " " << y;
      }
    }
  }
}

TEST(SoftLayer, LeavesEveryLevelWhereItIsTransparent) {
  image::Image image(256, 4, 3);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    image.pixels[i] = static_cast<std::uint8_t>(i / 3);
  }
  const image::Image before = image;
  std::vector<Cell> cells(6, Cell::Zero());
  cells[1] = Cell(0, 0, 0, 0.2F);  // too faint to be seen
  const SoftLayer layer{3, 2, cells, {0, 0}, {256 / 3.0, 2}, {0, 0, 256, 4}};
  EXPECT_TRUE(composite_over(image, layer).empty());
  EXPECT_EQ(image.pixels, before.pixels);
}

TEST(SoftLayer, CoversWhereItIsOpaque) {
  image::Image image = noise(20, 10);
  const SoftLayer layer{2,      1,        std::vector<Cell>(2, Cell(255, 128, 0, 255)),
                        {0, 0}, {10, 10}, {0, 0, 20, 10}};
  composite_over(image, layer);
  for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
    ASSERT_EQ(image.pixels[i], 255);
    ASSERT_NEAR(image.pixels[i + 1], 128, 1);
    ASSERT_EQ(image.pixels[i + 2], 0);
  }
}

// Without dither, a gradient of one level would be a step.
TEST(SoftLayer, IsDithered) {
  image::Image image = gray(64, 64, 100);
  const SoftLayer layer{2,      1,        {Cell(0, 0, 0, 0.5F), Cell(0, 0, 0, 3)},
                        {0, 0}, {32, 64}, {0, 0, 64, 64}};
  composite_over(image, layer);
  int changes = 0;
  for (int x = 1; x < 64; ++x) changes += value(image, x, 0, 0) != value(image, x - 1, 0, 0);
  EXPECT_GT(changes, 4);
}

TEST(SoftLayer, ReportsAllThatItChangesAndLittleMore) {
  const image::Image before = noise(200, 150);
  std::vector<Cell> cells(400, Cell::Zero());
  cells[5 * 20 + 7] = cells[5 * 20 + 9] = Cell(200, 0, 200, 250);
  cells[14 * 20 + 19] = Cell(0, 0, 0, 9);
  const SoftLayer layer = over(before, 20, 20, cells);
  image::Image after = before;
  const std::vector<image::Area> areas = composite_over(after, layer);
  long reported = 0;
  for (const image::Area& area : areas) reported += long{area.width} * area.height;
  EXPECT_LT(reported, 200 * 150 / 4);
  for (int y = 0; y < before.height; ++y) {
    for (int x = 0; x < before.width; ++x) {
      const bool is_reported = std::ranges::any_of(areas, [&](const image::Area& area) {
        return x >= area.x && x < area.x + area.width && y >= area.y && y < area.y + area.height;
      });
      if (is_reported) continue;
      for (int c = 0; c < 3; ++c) ASSERT_EQ(value(after, x, y, c), value(before, x, y, c));
    }
  }
}

TEST(SoftLayer, FadesByAFactor) {
  SoftLayer layer{1, 1, {Cell(40, 80, 120, 200)}, {0, 0}, {1, 1}, {0, 0, 1, 1}};
  scale_opacity(layer, 0.25);
  EXPECT_TRUE((layer.cells[0] == Cell(10, 20, 30, 50)).all());
}

}  // namespace
}  // namespace twrench::draw
