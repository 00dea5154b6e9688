#include "picture/compose/layer.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>

namespace twrench::picture {
namespace {

std::size_t offset(const image::Image& image, int x, int y) {
  return static_cast<std::size_t>(y) * image.row_bytes() +
         static_cast<std::size_t>(x) * static_cast<std::size_t>(image.channels);
}

/// value / 255, rounded, for 0 <= value <= 255 * 255.
unsigned divide_by_255(unsigned value) { return (value + 128 + ((value + 128) >> 8)) >> 8; }

template <int channels>
void lay_row_over(std::uint8_t* out, const std::uint8_t* in, int width) {
  for (int column = 0; column < width; ++column, in += 4, out += channels) {
    std::uint32_t color = 0;
    std::memcpy(&color, in, 4);
    if (color == 0) continue;  // most of a layer is empty, and most of the rest opaque
    if (in[3] == 255) {
      std::memcpy(out, in, channels);
      continue;
    }
    const unsigned through = 255U - in[3];
    for (int c = 0; c < channels; ++c) {
      const unsigned sum = in[c] + divide_by_255(out[c] * through);
      out[c] = static_cast<std::uint8_t>(std::min(sum, 255U));
    }
  }
}

}  // namespace

Layer layer_around(const image::Area& area, int margin, const image::Area& picture) {
  const image::Area all = image::common(
      {area.x - margin, area.y - margin, area.width + 2 * margin, area.height + 2 * margin},
      picture);
  return {image::Image(all.width, all.height, 4), all.x, all.y};
}

void copy_area(const Layer& from, Layer& to, const image::Area& area) {
  const image::Area held = image::common(area, from.area());
  for (int y = held.y; y < held.y + held.height; ++y) {
    const auto start = static_cast<std::ptrdiff_t>(offset(from.image, held.x - from.x, y - from.y));
    std::copy_n(from.image.pixels.begin() + start, 4 * held.width, to.image.pixels.begin() + start);
  }
}

void scale_opacity(Layer& layer, double factor) {
  for (std::uint8_t& value : layer.image.pixels) {
    value = static_cast<std::uint8_t>(std::lround(value * factor));
  }
}

std::vector<image::Area> composite_over(image::Image& image, const Layer& layer) {
  const image::Area area = image::common(layer.area(), {0, 0, image.width, image.height});
  assert(area == layer.area() && "a layer leaves the picture");
  const auto lay_row = image.channels == 4 ? lay_row_over<4> : lay_row_over<3>;
  for (int y = area.y; y < area.y + area.height; ++y) {
    lay_row(image.pixels.data() + offset(image, area.x, y),
            layer.image.pixels.data() + offset(layer.image, area.x - layer.x, y - layer.y),
            area.width);
  }
  return {area};
}

void unpremultiply(image::Image& image, const image::Area& area) {
  for (int row = 0; row < area.height; ++row) {
    std::uint8_t* p = image.pixels.data() + offset(image, area.x, area.y + row);
    for (int column = 0; column < area.width; ++column, p += 4) {
      const unsigned alpha = p[3];
      if (alpha == 0 || alpha == 255) continue;
      for (int c = 0; c < 3; ++c) {
        p[c] = static_cast<std::uint8_t>(std::min((p[c] * 255U + alpha / 2) / alpha, 255U));
      }
    }
  }
}

}  // namespace twrench::picture
