#include "picture/compose/cut.h"

#include <algorithm>

namespace twrench::picture {
namespace {

std::vector<int> edges(int first, int from, int length, int last, int count) {
  std::vector<int> result{first};
  for (int i = 1; i < count; ++i) result.push_back(from + length * i / count);
  result.push_back(last);
  return result;
}

}  // namespace

image::Area cut_top(image::Area& rest, int height, int gap) {
  const image::Area piece{rest.x, rest.y, rest.width, height};
  rest.y += height + gap;
  rest.height -= height + gap;
  return piece;
}

image::Area cut_bottom(image::Area& rest, int height, int gap) {
  const image::Area piece{rest.x, rest.y + rest.height - height, rest.width, height};
  rest.height -= height + gap;
  return piece;
}

image::Area cut_left(image::Area& rest, int width, int gap) {
  const image::Area piece{rest.x, rest.y, width, rest.height};
  rest.x += width + gap;
  rest.width -= width + gap;
  return piece;
}

image::Area cut_right(image::Area& rest, int width, int gap) {
  const image::Area piece{rest.x + rest.width - width, rest.y, width, rest.height};
  rest.width -= width + gap;
  return piece;
}

image::Area centred_square(const image::Area& area) {
  const int side = std::min(area.width, area.height);
  return {area.x + (area.width - side) / 2, area.y + (area.height - side) / 2, side, side};
}

std::vector<Share> shares(const image::Area& whole, const image::Area& middle, int columns,
                          int rows) {
  const auto xs = edges(whole.x, middle.x, middle.width, whole.x + whole.width, columns);
  const auto ys = edges(whole.y, middle.y, middle.height, whole.y + whole.height, rows);
  std::vector<Share> result;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const auto x = static_cast<std::size_t>(column), y = static_cast<std::size_t>(row);
      result.push_back({{xs[x], ys[y], xs[x + 1] - xs[x], ys[y + 1] - ys[y]}, column, row});
    }
  }
  return result;
}

}  // namespace twrench::picture
