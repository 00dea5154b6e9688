#include "image/yuv.h"

#include <algorithm>
#include <cstddef>

namespace twrench::image {
namespace {

/// A row of the matrix of ITU-R BT.709-6, items 3.2 to 3.4, for 8-bit R'G'B', in units of 2^-16.
/// Rounding changes each weight by at most 0.6 of a unit: 0.006 of a level for the brightest pixel.
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

// These are inlined into each function below and compiled for the instructions that it may use.
// Because nothing overlaps, the compiler can vectorise them.
#define TWRENCH_INLINE [[gnu::always_inline]] inline

TWRENCH_INLINE int weighted(const Weights& weights, int red, int green, int blue) {
  return weights.red * red + weights.green * green + weights.blue * blue;
}

/// Rounds `sum` of 2^doublings pixels plus `offset`.
TWRENCH_INLINE std::uint8_t channel_level(int sum, int offset, int doublings) {
  const int bits = shift + doublings;
  return static_cast<std::uint8_t>((sum + (offset << bits) + (1 << (bits - 1))) >> bits);
}

TWRENCH_INLINE void luma_row(const std::uint8_t* __restrict rgb, std::uint8_t* __restrict out,
                             int count) {
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    out[i] = channel_level(weighted(luma, rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]), 16, 0);
  }
}

TWRENCH_INLINE void column_row(const std::uint8_t* __restrict upper,
                               const std::uint8_t* __restrict lower, int* __restrict blue,
                               int* __restrict red, int count) {
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    const int r = upper[3 * i] + lower[3 * i];
    const int g = upper[3 * i + 1] + lower[3 * i + 1];
    const int b = upper[3 * i + 2] + lower[3 * i + 2];
    blue[i] = weighted(blue_difference, r, g, b);
    red[i] = weighted(red_difference, r, g, b);
  }
}

TWRENCH_INLINE void chroma_row(const int* __restrict columns, std::uint8_t* __restrict out,
                               int count) {
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    out[i] = channel_level(columns[2 * i] + 2 * columns[2 * i + 1] + columns[2 * i + 2], 128, 3);
  }
}

#undef TWRENCH_INLINE

}  // namespace

YuvRows common_yuv_rows() { return {luma_row, column_row, chroma_row}; }

#ifdef __x86_64__

namespace {

[[gnu::target("avx2")]] void wide_luma(const std::uint8_t* rgb, std::uint8_t* out, int count) {
  luma_row(rgb, out, count);
}

[[gnu::target("avx2")]] void wide_columns(const std::uint8_t* upper, const std::uint8_t* lower,
                                          int* blue, int* red, int count) {
  column_row(upper, lower, blue, red, count);
}

[[gnu::target("avx2")]] void wide_chroma(const int* columns, std::uint8_t* out, int count) {
  chroma_row(columns, out, count);
}

}  // namespace

YuvRows fastest_yuv_rows() {
  if (!__builtin_cpu_supports("avx2")) return common_yuv_rows();
  return {wide_luma, wide_columns, wide_chroma};
}

#else

YuvRows fastest_yuv_rows() { return common_yuv_rows(); }

#endif

namespace {

std::size_t index(int row, int width, int column) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
         static_cast<std::size_t>(column);
}

int half(int size) { return (size + 1) / 2; }

}  // namespace

Yuv420::Yuv420(int width, int height)
    : width_(width),
      height_(height),
      rows_(fastest_yuv_rows()),
      bytes_(index(height, width, 0) + 2 * index(half(height), half(width), 0)),
      blue_columns_(static_cast<std::size_t>(width) + 2),
      red_columns_(blue_columns_.size()) {}

void Yuv420::update(const Image& image, const Area& area) {
  update_luma(image, area);
  update_chroma(image, area);
}

void Yuv420::update_luma(const Image& image, const Area& area) {
  for (int y = area.y; y < area.y + area.height; ++y) {
    const std::size_t first = index(y, width_, area.x);
    rows_.luma(&image.pixels[3 * first], &bytes_[first], area.width);
  }
}

void Yuv420::update_chroma(const Image& image, const Area& area) {
  const int width = half(width_);
  std::uint8_t* const blue = &bytes_[index(height_, width_, 0)];
  std::uint8_t* const red = blue + index(half(height_), width, 0);
  // A chroma sample on column 2c is half of that column and a quarter of each neighbour: column x
  // affects the samples x/2 and (x+1)/2. Beyond the edges, the edge column is repeated.
  const int first = area.x / 2;
  const int count = std::min((area.x + area.width) / 2, width - 1) - first + 1;
  const int left = std::max(2 * first - 1, 0);
  const int right = std::min(2 * (first + count) - 1, width_ - 1);
  for (int row = area.y / 2; row < half(area.y + area.height); ++row) {
    const int lower = std::min(2 * row + 1, height_ - 1);
    // Column x is element x + 1.
    const std::size_t begin = static_cast<std::size_t>(left) + 1;
    rows_.columns(&image.pixels[3 * index(2 * row, width_, left)],
                  &image.pixels[3 * index(lower, width_, left)], &blue_columns_[begin],
                  &red_columns_[begin], right - left + 1);
    for (std::vector<int>* columns : {&blue_columns_, &red_columns_}) {
      columns->front() = (*columns)[1];
      columns->back() = (*columns)[columns->size() - 2];
    }
    const std::size_t out = index(row, width, first);
    rows_.chroma(&blue_columns_[2 * static_cast<std::size_t>(first)], &blue[out], count);
    rows_.chroma(&red_columns_[2 * static_cast<std::size_t>(first)], &red[out], count);
  }
}

}  // namespace twrench::image
