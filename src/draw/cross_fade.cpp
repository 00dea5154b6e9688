#include "draw/cross_fade.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "picture/look/material.h"

namespace twrench::draw {
namespace {

using Levels = std::array<double, 256>;

const Levels& linear_levels() {
  static const Levels levels = [] {
    Levels table{};
    for (int i = 0; i < 256; ++i) table[static_cast<std::size_t>(i)] = picture::linear_from_srgb(i);
    return table;
  }();
  return levels;
}

std::uint8_t srgb_from_linear(double light) {
  const double s = light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(s, 0.0, 1.0)));
}

/// Returns the mean of each pair of levels. There are far fewer pairs than pixels.
std::vector<std::uint8_t> means(double share) {
  const Levels& linear = linear_levels();
  std::vector<std::uint8_t> table;
  table.reserve(256 * 256);
  for (const double a : linear) {
    for (const double b : linear) table.push_back(srgb_from_linear(std::lerp(a, b, share)));
  }
  return table;
}

void fade_opaque(const image::Image& to, double share, image::Image& image) {
  const std::vector<std::uint8_t> mean = means(share);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    image.pixels[i] = mean[std::size_t{256} * image.pixels[i] + to.pixels[i]];
  }
}

/// Weights colours by their alpha.
void fade_translucent(const image::Image& to, double share, image::Image& image) {
  const Levels& linear = linear_levels();
  for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
    std::uint8_t* const a = &image.pixels[i];
    const std::uint8_t* const b = &to.pixels[i];
    if (std::equal(a, a + 4, b)) continue;
    const double before = (1 - share) * a[3], after = share * b[3];
    const double alpha = before + after;
    for (std::size_t c = 0; c < 3 && alpha > 0; ++c) {
      a[c] = srgb_from_linear((before * linear[a[c]] + after * linear[b[c]]) / alpha);
    }
    a[3] = static_cast<std::uint8_t>(std::lround(alpha));
  }
}

}  // namespace

image::Image cross_fade(const image::Image& from, const image::Image& to, double share) {
  image::Image image = from;
  if (image.channels == 4) {
    fade_translucent(to, share, image);
  } else {
    fade_opaque(to, share, image);
  }
  return image;
}

}  // namespace twrench::draw
