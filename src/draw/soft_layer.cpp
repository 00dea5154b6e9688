#include "draw/soft_layer.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <iterator>

#include "image/image.h"
#include "picture/compose/layer.h"

namespace twrench::draw {
namespace {

// Levels are in units of 2^-6, so that the difference of two, doubled, fits into 16 bits.
constexpr int level_bits = 6;
constexpr int band_height = 32;          // rows of each area that is reported as affected
constexpr float opaque = (1 << 14) - 1;  // alpha, in units of 2^-14: four times it fits too

/// A position between the centres of two cells of a row or column of cells.
struct Between {
  int first, second;
  float share;  ///< of the second
};

/// `place` is in cells, from the outer edge of the first cell.
Between between(double place, int count) {
  const double within = std::clamp(place - 0.5, 0.0, count - 1.0);
  const int first = static_cast<int>(within);
  return {first, std::min(first + 1, count - 1), static_cast<float>(within - first)};
}

/// A range of columns, of cells or of pixels; empty unless begin < end.
struct Range {
  int begin = 0, end = 0;

  bool is_empty() const { return begin >= end; }
};

/// Returns the least range that contains both.
Range around(const Range& a, const Range& b) {
  if (a.is_empty()) return b;
  if (b.is_empty()) return a;
  return {std::min(a.begin, b.begin), std::max(a.end, b.end)};
}

/// Returns the least range of a row's cells that contains all visible ones.
Range visible(const SoftLayer::Cell* row, int columns) {
  constexpr float least = 0.25;  // lower values are lost in rounding
  const auto is_visible = [](const SoftLayer::Cell& cell) { return cell[3] >= least; };
  const auto* const end = row + columns;
  const auto* const first = std::find_if(row, end, is_visible);
  if (first == end) return {};
  const auto* const last =
      std::find_if(std::reverse_iterator(end), std::reverse_iterator(first), is_visible).base();
  return {static_cast<int>(first - row), static_cast<int>(last - row)};
}

/// A row of cells interpolated to the columns of the picture, with three values for each pixel like
/// the picture, so that vector instructions can composite rows of pixels.
struct Line {
  int row = -1;
  std::vector<std::int16_t> color, alpha;
};

/// Composites over `out` the values of `range`, interpolated between two lines at `share` / 2^15 of
/// the way from the first.
void lay_values(const Line& upper, const Line& lower, std::int16_t share,
                const std::vector<std::int16_t>& rounding, const Range& range,
                std::uint8_t* __restrict out) {
  const auto mixed = [share](std::int16_t from, std::int16_t to) {
    const auto doubled = static_cast<std::int16_t>(2 * (to - from));
    return static_cast<std::int16_t>(from + static_cast<std::int16_t>((doubled * share) >> 16));
  };
  const std::int16_t* __restrict upper_color = upper.color.data();
  const std::int16_t* __restrict lower_color = lower.color.data();
  const std::int16_t* __restrict upper_alpha = upper.alpha.data();
  const std::int16_t* __restrict lower_alpha = lower.alpha.data();
  const std::int16_t* __restrict round = rounding.data();
  for (std::ptrdiff_t i = range.begin; i < range.end; ++i) {
    const std::int16_t color = mixed(upper_color[i], lower_color[i]);
    const std::int16_t alpha = mixed(upper_alpha[i], lower_alpha[i]);
    const auto through = static_cast<std::uint16_t>(65535 - 4 * alpha);
    const auto level = static_cast<std::uint16_t>(out[i] << level_bits);
    const auto below = static_cast<std::uint16_t>((std::uint32_t{level} * through) >> 16);
    const auto sum = static_cast<std::int16_t>(below + color + round[i]);
    out[i] = static_cast<std::uint8_t>(std::min<std::int16_t>(sum >> level_bits, 255));
  }
}

/// Interpolates a soft layer over the pixels of `area`, row by row from the top.
class Enlarger {
 public:
  Enlarger(const SoftLayer& layer, const image::Area& area) : layer_(layer), area_(area) {
    const auto values = 3 * static_cast<std::size_t>(area.width);
    for (Line& line : lines_) {
      line.color.resize(values);
      line.alpha.resize(values);
    }
    for (int x = 0; x < area.width; ++x) {
      const double place = (area.x + x + 0.5 - layer.corner.x()) / layer.cell_size.x();
      columns_.push_back(between(place, layer.columns));
    }
    for (int row = 0; row < layer.rows; ++row) {
      visible_.push_back(pixels(visible(cells(row), layer.columns)));
    }
    for (int y = 0; y < 2; ++y) {
      std::vector<std::int16_t>& rounding = rounding_[static_cast<std::size_t>(y)];
      for (int x = 0; x < area.width; ++x) {
        const float step = 0.5F + image::dither(area.x + x, y);
        rounding.insert(rounding.end(), 3, static_cast<std::int16_t>(step * (1 << level_bits)));
      }
    }
  }

  /// Composites row y of the picture over `out`, the row's first pixel within the area, and returns
  /// the pixels that it may have changed, counted from there.
  Range lay_row_over(int y, std::uint8_t* out) {
    const double place = (y + 0.5 - layer_.corner.y()) / layer_.cell_size.y();
    const auto [first, second, share] = between(place, layer_.rows);
    const Range range = around(visible_of(first), visible_of(second));
    if (range.is_empty()) return range;
    lay_values(line(first), line(second), static_cast<std::int16_t>(share * 32767),
               rounding_[static_cast<std::size_t>(y % 2)], {3 * range.begin, 3 * range.end}, out);
    return range;
  }

 private:
  const SoftLayer::Cell* cells(int row) const {
    return layer_.cells.data() + std::ptrdiff_t{row} * layer_.columns;
  }

  /// Returns the pixels whose colour depends on those cells.
  Range pixels(const Range& cells) const {
    if (cells.is_empty()) return {};
    const auto begin = std::ranges::lower_bound(columns_, cells.begin, {}, &Between::second);
    const auto end = std::ranges::lower_bound(columns_, cells.end, {}, &Between::first);
    return {static_cast<int>(begin - columns_.begin()), static_cast<int>(end - columns_.begin())};
  }

  const Range& visible_of(int row) const { return visible_[static_cast<std::size_t>(row)]; }

  /// Returns the line of a row of cells. Two neighbouring lines are kept.
  const Line& line(int row) {
    Line& line = lines_[static_cast<std::size_t>(row % 2)];
    if (line.row != row) interpolate(row, line);
    return line;
  }

  /// Interpolates as much of the row as it and its neighbours need.
  void interpolate(int row, Line& line) const {
    Range range = visible_of(row);
    if (row > 0) range = around(range, visible_of(row - 1));
    if (row + 1 < layer_.rows) range = around(range, visible_of(row + 1));
    const Eigen::Array4f units(1 << level_bits, 1 << level_bits, 1 << level_bits, opaque / 255);
    const SoftLayer::Cell* const cell = cells(row);
    for (int x = range.begin; x < range.end; ++x) {
      const auto& [first, second, share] = columns_[static_cast<std::size_t>(x)];
      const SoftLayer::Cell mean = cell[first] + share * (cell[second] - cell[first]);
      const Eigen::Array4i value = (mean * units).cast<int>();
      for (int c = 0; c < 3; ++c) {
        const std::size_t i = 3 * static_cast<std::size_t>(x) + static_cast<std::size_t>(c);
        line.color[i] = static_cast<std::int16_t>(value[c]);
        line.alpha[i] = static_cast<std::int16_t>(value[3]);
      }
    }
    line.row = row;
  }

  const SoftLayer& layer_;
  image::Area area_;
  std::vector<Between> columns_;  // of each pixel
  std::vector<Range> visible_;    // pixels that each row of cells may change
  // Offsets added before rounding down, on even rows and on odd ones.
  std::array<std::vector<std::int16_t>, 2> rounding_;
  std::array<Line, 2> lines_;
};

/// Returns a soft layer at the resolution of the picture, for pictures with alpha. They are rare,
/// so this takes several times as long as an Enlarger.
picture::Layer enlarged(const SoftLayer& layer, const image::Area& area) {
  picture::Layer result{{area.width, area.height, 4}, area.x, area.y};
  std::uint8_t* out = result.image.pixels.data();
  const auto place = [&](int pixel, int axis) {
    return (pixel + 0.5 - layer.corner[axis]) / layer.cell_size[axis];
  };
  for (int y = area.y; y < area.y + area.height; ++y) {
    const auto [upper, lower, down] = between(place(y, 1), layer.rows);
    const SoftLayer::Cell* const above = layer.cells.data() + std::ptrdiff_t{upper} * layer.columns;
    const SoftLayer::Cell* const below = layer.cells.data() + std::ptrdiff_t{lower} * layer.columns;
    for (int x = area.x; x < area.x + area.width; ++x, out += 4) {
      const auto [left, right, across] = between(place(x, 0), layer.columns);
      const SoftLayer::Cell top = above[left] + across * (above[right] - above[left]);
      const SoftLayer::Cell bottom = below[left] + across * (below[right] - below[left]);
      const SoftLayer::Cell mean = top + down * (bottom - top) + 0.5F + image::dither(x, y);
      for (int c = 0; c < 4; ++c) out[c] = static_cast<std::uint8_t>(mean[c]);
    }
  }
  return result;
}

}  // namespace

void scale_opacity(SoftLayer& layer, double factor) {
  for (SoftLayer::Cell& cell : layer.cells) cell *= static_cast<float>(factor);
}

std::vector<image::Area> composite_over(image::Image& image, const SoftLayer& layer) {
  const image::Area area = image::common(layer.covered, {0, 0, image.width, image.height});
  assert(area == layer.covered && "a layer leaves the picture");
  if (area.width == 0 || area.height == 0) return {};
  if (image.channels == 4) return composite_over(image, enlarged(layer, area));
  Enlarger enlarger(layer, area);
  std::vector<image::Area> affected;
  for (int top = area.y; top < area.y + area.height; top += band_height) {
    const int height = std::min(band_height, area.y + area.height - top);
    Range range;
    for (int y = top; y < top + height; ++y) {
      std::uint8_t* const out = &image.pixels[static_cast<std::size_t>(y) * image.row_bytes() +
                                              3 * static_cast<std::size_t>(area.x)];
      range = around(range, enlarger.lay_row_over(y, out));
    }
    if (range.is_empty()) continue;
    affected.push_back({area.x + range.begin, top, range.end - range.begin, height});
  }
  return affected;
}

}  // namespace twrench::draw
