#include "render/background.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

namespace twrench {
namespace {

using Eigen::Array3d;

/// Ordered dither on a square of two by two, in [0, 1): quarter steps are too fine for bands to be
/// seen, and a pattern this short costs a PNG file half of what noise would.
double dither(int x, int y) {
  static constexpr double pattern[2][2] = {{0.125, 0.625}, {0.875, 0.375}};
  return pattern[y % 2][x % 2];
}

double smooth_step(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// exp(-((x - centre) / width)^2)
double bell(double x, double centre, double width) {
  const double d = (x - centre) / width;
  return std::exp(-d * d);
}

/// What of the graded background depends on one of the two coordinates alone: u goes from -1 to 1
/// across, v from 0 at the top to 1.
struct ColumnTerms {
  explicit ColumnTerms(double u)
      : droop(0.10 * u * u), vignette(1 - 0.22 * u * u), light(bell(u, 0, 0.42)) {}
  double droop, vignette, light;
};
struct RowTerms {
  explicit RowTerms(double v) : height(v), light(bell(v, 1.02, 0.30)) {}
  double height, light;
};

/// The sRGB colour there, 0 to 255.
Array3d graded(const ColumnTerms& column, const RowTerms& row) {
  const Array3d night(9, 10, 13);
  const Array3d slate(46, 50, 61);
  const Array3d pool(46, 45, 41);
  const double floor = smooth_step(0.15, 0.85, row.height - column.droop);
  return (night + floor * (slate - night)) * column.vignette + column.light * row.light * pool;
}

Image flat(const Color& color, int width, int height) {
  Image image(width, height, 3);
  for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
    image.pixels[i] = static_cast<std::uint8_t>(color.red);
    image.pixels[i + 1] = static_cast<std::uint8_t>(color.green);
    image.pixels[i + 2] = static_cast<std::uint8_t>(color.blue);
  }
  return image;
}

}  // namespace

Image background(const Look& look, int width, int height) {
  if (look.background) return flat(*look.background, width, height);
  std::vector<ColumnTerms> columns;
  columns.reserve(static_cast<std::size_t>(width));
  for (int x = 0; x < width; ++x) columns.emplace_back((2 * x + 1.0) / width - 1);
  Image image(width, height, 3);
  auto out = image.pixels.begin();
  for (int y = 0; y < height; ++y) {
    const RowTerms row((y + 0.5) / height);
    for (int x = 0; x < width; ++x) {
      const Array3d color = graded(columns[static_cast<std::size_t>(x)], row);
      const double offset = dither(x, y);  // rounds up as often as the fraction lost would say
      for (const double value : color) *out++ = static_cast<std::uint8_t>(value + offset);
    }
  }
  return image;
}

}  // namespace twrench
