#include "picture/look/background.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "image/image.h"
#include "picture/look/theme.h"

namespace twrench::picture {
namespace {

using Eigen::Array3d;

double smooth_step(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// The terms of the gradient that depend on one coordinate only: u goes from -1 to 1 across, v from
/// 0 at the top to 1.
struct ColumnTerms {
  ColumnTerms(const Backdrop& backdrop, double u)
      : droop(0.10 * u * u), darkening(backdrop.vignette * u * u) {}
  double droop, darkening;
};

Array3d array_of(const Color& color) {
  return Eigen::Array3i(color.red, color.green, color.blue).cast<double>();
}

/// Stars are soft dots at least two pixels wide; video encoding would remove smaller ones or make
/// them twinkle. A generator with a fixed seed places them, independently of the picture's size.
void add_stars(image::Image& image, int count) {
  std::mt19937 random(1);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
  for (int i = 0; i < count; ++i) {
    const double x = uniform() * image.width;
    const double y = uniform() * image.height;
    const double brightness = std::pow(uniform(), 5.0);  // Few are bright.
    const double true_radius = image.height / 1080.0 * (0.75 + 0.6 * brightness);
    const double radius = std::max(0.8, true_radius);
    // A star drawn wider than its true size is fainter.
    const Array3d color = (40 + 190 * brightness) * std::min(1.0, true_radius / radius) *
                          Array3d(1, 0.94 + 0.06 * uniform(), 1);
    const int margin = static_cast<int>(std::ceil(3 * radius));
    for (int row = static_cast<int>(y) - margin; row <= static_cast<int>(y) + margin; ++row) {
      for (int column = static_cast<int>(x) - margin; column <= static_cast<int>(x) + margin;
           ++column) {
        if (row < 0 || row >= image.height || column < 0 || column >= image.width) continue;
        const double distance = std::hypot(column + 0.5 - x, row + 0.5 - y) / radius;
        std::uint8_t* p = &image.pixels[static_cast<std::size_t>(row) * image.row_bytes() +
                                        static_cast<std::size_t>(column) * 3];
        for (int c = 0; c < 3; ++c) {
          const double light = p[c] + color[c] * std::exp(-distance * distance);
          p[c] = static_cast<std::uint8_t>(std::min(light, 255.0));
        }
      }
    }
  }
}

image::Image flat(const Color& color, int width, int height) {
  image::Image image(width, height, 3);
  for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
    image.pixels[i] = static_cast<std::uint8_t>(color.red);
    image.pixels[i + 1] = static_cast<std::uint8_t>(color.green);
    image.pixels[i + 2] = static_cast<std::uint8_t>(color.blue);
  }
  return image;
}

}  // namespace

image::Image background(const scene::Look& look, int width, int height, bool still_stars) {
  if (look.background) return flat(*look.background, width, height);
  const Backdrop& backdrop = style_of(look.theme).backdrop;
  const Array3d above = array_of(backdrop.above);
  const Array3d below = array_of(backdrop.below);
  std::vector<ColumnTerms> columns;
  columns.reserve(static_cast<std::size_t>(width));
  for (int x = 0; x < width; ++x) columns.emplace_back(backdrop, (2 * x + 1.0) / width - 1);
  image::Image image(width, height, 3);
  auto out = image.pixels.begin();
  for (int y = 0; y < height; ++y) {
    const double v = (y + 0.5) / height;
    for (int x = 0; x < width; ++x) {
      const ColumnTerms& column = columns[static_cast<std::size_t>(x)];
      const double depth = smooth_step(0.15, 0.85, v - column.droop);
      const Array3d color = above + depth * (below - above);
      const double offset = 0.5 + static_cast<double>(image::dither(x, y));
      const double darker = column.darkening * color[1];  // the same in all channels
      for (const double value : color) *out++ = static_cast<std::uint8_t>(value - darker + offset);
    }
  }
  if (still_stars) add_stars(image, backdrop.stars);
  return image;
}

}  // namespace twrench::picture
