#include "image/yuv.h"

#include <algorithm>
#include <cstddef>

namespace twrench::image {
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
