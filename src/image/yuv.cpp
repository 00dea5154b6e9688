#include "image/yuv.h"

#include <algorithm>
#include <cstddef>

namespace twrench {
namespace {

/// A row of ITU-R BT.709-6, items 3.2 to 3.4, on 8-bit R'G'B', as integers over 2^16. Rounding
/// leaves 0.6 of a unit in each at most: 0.006 of a level for the brightest pixel.
struct Weights {
  int red, green, blue;
};
constexpr int shift = 16;

// Kr = 0.2126, Kb = 0.0722. Y' spans 219 levels, Cb and Cr 224. The weights of Y' add up to
// 219/255, those of chroma to 0, so that white is 235 and gray has no colour.
constexpr Weights luma{11966, 40254, 4064};
constexpr Weights blue_difference{-6596, -22189, 28785};
constexpr Weights red_difference{28784, -26145, -2639};
static_assert(luma.red + luma.green + luma.blue == (219 * (1 << shift) + 127) / 255);
static_assert(blue_difference.red + blue_difference.green + blue_difference.blue == 0);
static_assert(red_difference.red + red_difference.green + red_difference.blue == 0);

/// `rgb` weighted, plus `offset`, rounded; `rgb` are sums of 2^doublings pixels.
std::uint8_t weighted(const Weights& weights, int red, int green, int blue, int offset,
                      int doublings) {
  const int bits = shift + doublings;
  const int sum = weights.red * red + weights.green * green + weights.blue * blue;
  return static_cast<std::uint8_t>((sum + (offset << bits) + (1 << (bits - 1))) >> bits);
}

std::size_t index(int row, int width, int column) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
         static_cast<std::size_t>(column);
}

int half(int size) { return (size + 1) / 2; }

}  // namespace

Yuv420::Yuv420(int width, int height)
    : width_(width),
      height_(height),
      bytes_(index(height, width, 0) + 2 * index(half(height), half(width), 0)),
      columns_(3 * static_cast<std::size_t>(width)) {}

void Yuv420::update(const Image& image, const Area& area) {
  update_luma(image, area);
  update_chroma(image, area);
}

void Yuv420::update_luma(const Image& image, const Area& area) {
  for (int y = area.y; y < area.y + area.height; ++y) {
    const std::uint8_t* in = &image.pixels[3 * index(y, width_, area.x)];
    std::uint8_t* out = &bytes_[index(y, width_, area.x)];
    for (int x = 0; x < area.width; ++x, in += 3) {
      out[x] = weighted(luma, in[0], in[1], in[2], 16, 0);
    }
  }
}

void Yuv420::update_chroma(const Image& image, const Area& area) {
  const int width = half(width_);
  std::uint8_t* const blue = &bytes_[index(height_, width_, 0)];
  std::uint8_t* const red = blue + index(half(height_), width, 0);
  // A sample on column 2c is a quarter of its neighbours' and half of its own: column x bears on
  // the samples x/2 and (x+1)/2.
  const int first = area.x / 2;
  const int last = std::min((area.x + area.width) / 2, width - 1);
  const int left = std::max(2 * first - 1, 0);
  const int right = std::min(2 * last + 1, width_ - 1);
  for (int row = area.y / 2; row < half(area.y + area.height); ++row) {
    const std::uint8_t* const upper = &image.pixels[3 * index(2 * row, width_, 0)];
    const std::uint8_t* const lower =
        &image.pixels[3 * index(std::min(2 * row + 1, height_ - 1), width_, 0)];
    for (int i = 3 * left; i < 3 * (right + 1); ++i) {
      columns_[static_cast<std::size_t>(i)] = upper[i] + lower[i];
    }
    for (int c = first; c <= last; ++c) {
      const int* const here = &columns_[6 * static_cast<std::size_t>(c)];
      const int* const before = c == 0 ? here : here - 3;
      const int* const after = 2 * c + 1 == width_ ? here : here + 3;
      const auto sum = [&](int i) { return before[i] + 2 * here[i] + after[i]; };
      const std::size_t out = index(row, width, c);
      blue[out] = weighted(blue_difference, sum(0), sum(1), sum(2), 128, 3);
      red[out] = weighted(red_difference, sum(0), sum(1), sum(2), 128, 3);
    }
  }
}

}  // namespace twrench
