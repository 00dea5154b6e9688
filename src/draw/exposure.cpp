#include "draw/exposure.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "picture/look/material.h"

namespace twrench::draw {
namespace {

// Number of levels of linear light: finer than sRGB's smallest step except in the darkest tones.
constexpr int steps = 4096;

/// The linear light of the sRGB values.
template <typename Number>
const std::array<Number, 256>& linear_levels() {
  static const std::array<Number, 256> levels = [] {
    std::array<Number, 256> table{};
    for (int i = 0; i < 256; ++i) {
      table[static_cast<std::size_t>(i)] = static_cast<Number>(picture::linear_from_srgb(i));
    }
    return table;
  }();
  return levels;
}

/// Returns the sRGB value, 0 to 255, of linear light from 0 to 1.
double srgb_from_linear(double light) {
  return 255 * (light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055);
}

/// Returns a table of sRGB values at i / steps of full light.
std::vector<float> srgb_table() {
  std::vector<float> table;
  for (int i = 0; i <= steps; ++i) {
    table.push_back(static_cast<float>(srgb_from_linear(static_cast<double>(i) / steps)));
  }
  return table;
}

}  // namespace

Exposure::Exposure(int width, int height)
    : width_(width),
      height_(height),
      sums_(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

void Exposure::add(const image::Image& image) {
  const std::array<float, 256>& linear = linear_levels<float>();
  ++count_;
  for (std::size_t i = 0; i < sums_.size(); i += 4) {
    const std::uint8_t* p = &image.pixels[i];
    const unsigned alpha = p[3];
    if (alpha == 0) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      // Most pixels are opaque, and divisions are slow.
      const unsigned straight =
          alpha == 255 ? p[c] : std::min((p[c] * 255U + alpha / 2) / alpha, 255U);
      sums_[i + c] += static_cast<float>(alpha) * linear[straight];
    }
    sums_[i + 3] += static_cast<float>(alpha);
  }
}

image::Image Exposure::mean() const {
  const auto rounded = [](float value) { return static_cast<std::size_t>(value + 0.5F); };
  static const std::vector<float> srgb = srgb_table();
  image::Image image(width_, height_, 4);
  for (std::size_t i = 0; i < sums_.size(); i += 4) {
    const float alpha = sums_[i + 3];
    if (alpha == 0) continue;
    const float mean_alpha = alpha / static_cast<float>(count_);
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t step = rounded(sums_[i + c] / alpha * steps);
      image.pixels[i + c] = static_cast<std::uint8_t>(rounded(srgb[step] * mean_alpha / 255));
    }
    image.pixels[i + 3] = static_cast<std::uint8_t>(rounded(mean_alpha));
  }
  return image;
}

void PendingExposure::add(gl::Readback picture) {
  constexpr std::size_t most = 8;  // enough to keep a card busy while one is waited for
  in_transfer_.push_back(std::move(picture));
  while (!in_transfer_.empty() && (in_transfer_.front().is_ready() || in_transfer_.size() > most)) {
    add_first();
  }
}

void PendingExposure::fetch() {
  while (!in_transfer_.empty()) add_first();
}

void PendingExposure::add_first() {
  exposure_.add(in_transfer_.front().finish());
  in_transfer_.pop_front();
}

namespace {

std::uint8_t rounded_srgb(double light) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(srgb_from_linear(light), 0.0, 255.0)));
}

/// Returns the mean of each pair of levels. There are far fewer pairs than pixels.
std::vector<std::uint8_t> means(double share) {
  const std::array<double, 256>& linear = linear_levels<double>();
  std::vector<std::uint8_t> table;
  table.reserve(256 * 256);
  for (const double a : linear) {
    for (const double b : linear) table.push_back(rounded_srgb(std::lerp(a, b, share)));
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
  const std::array<double, 256>& linear = linear_levels<double>();
  for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
    std::uint8_t* const a = &image.pixels[i];
    const std::uint8_t* const b = &to.pixels[i];
    if (std::equal(a, a + 4, b)) continue;
    const double before = (1 - share) * a[3], after = share * b[3];
    const double alpha = before + after;
    for (std::size_t c = 0; c < 3 && alpha > 0; ++c) {
      a[c] = rounded_srgb((before * linear[a[c]] + after * linear[b[c]]) / alpha);
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
