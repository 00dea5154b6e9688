#include "comparison/picture_pair.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <twrench/base/error.h>

#include <algorithm>
#include <cstdint>

#include "image/compare.h"
#include "image/image.h"
#include "image/png.h"
#include "system/error.h"

namespace twrench::comparison {
namespace {

template <typename Kind>
void copy_area(const image::Area& area, const Kind& from, Kind& to) {
  const auto sample = [&](int x, int y) {
    return (std::ptrdiff_t{y} * from.width + x) * from.channels;
  };
  for (int y = area.y; y < area.y + area.height; ++y) {
    std::copy_n(from.pixels.begin() + sample(area.x, y), area.width * from.channels,
                to.pixels.begin() + sample(area.x, y));
  }
}

/// Throws FileError if the picture takes about a gigabyte, and its file is far too small for a
/// picture of that size that shows anything.
void require_moderate(const PngFile& file) {
  const image::PngHeader header = image::png_header(file.bytes);
  const std::uint64_t pixels = std::uint64_t{header.width} * header.height;
  constexpr std::uint64_t large = 8192 * 8192, most_pixels_per_byte = 30;
  if (pixels <= large || pixels <= most_pixels_per_byte * file.bytes.size()) return;
  throw system::FileError(
      "cannot read " + file.name,
      fmt::format("it has {}x{} pixels in {} bytes: hardly anything can be on it", header.width,
                  header.height, file.bytes.size()),
      "compare pictures of at most 8192x8192 pixels");
}

constexpr const char* expected_is_opaque =
    "the expected picture has an alpha channel, opaque everywhere, and the actual one has none";
constexpr const char* actual_is_opaque =
    "the actual picture has an alpha channel, opaque everywhere, and the expected one has none";

}  // namespace

void require_within(std::span<const image::Area> areas, int width, int height,
                    const std::string& name) {
  const image::Area whole{0, 0, width, height};
  for (const image::Area& area : areas) {
    const bool is_within = image::common(area, whole) == area;
    if (is_within && area != whole) continue;
    throw InvalidArgument(
        fmt::format("the area {},{},{}x{}", area.x, area.y, area.width, area.height),
        is_within
            ? fmt::format("it is all of {}: nothing is left to compare", name)
            : fmt::format("it is not within {}, which has {}x{} pixels", name, width, height));
  }
}

PicturePair::PicturePair(const PngFile& expected, const PngFile& actual) : name_(actual.name) {
  for (const PngFile* file : {&expected, &actual}) {
    image::require_png(file->bytes, file->name);
    require_moderate(*file);
  }
  const int bits = image::png_header(expected.bytes).bit_depth;
  const int actual_bits = image::png_header(actual.bytes).bit_depth;
  if (bits == 16 || actual_bits == 16) {
    images_ = Pair<image::DeepImage>{image::decode_deep_png(expected.bytes, expected.name),
                                     image::decode_deep_png(actual.bytes, actual.name)};
  } else {
    images_ = Pair<image::Image>{image::decode_png(expected.bytes, expected.name),
                                 image::decode_png(actual.bytes, actual.name)};
  }
  if ((bits == 16) != (actual_bits == 16)) {
    notes_.push_back(fmt::format("the expected picture has {} bits per channel, the actual one {}",
                                 bits, actual_bits));
  }
  unify_alpha();
  if (const auto chunks = image::different_color_chunks(expected.bytes, actual.bytes);
      !chunks.empty()) {
    notes_.push_back(fmt::format("the descriptions of colours differ ({}); they are not applied",
                                 fmt::join(chunks, ", ")));
  }
}

void PicturePair::unify_alpha() {
  std::visit(
      [this](auto& pair) {
        auto& [expected, actual] = pair;
        if (expected.channels == 4 && actual.channels == 3 && image::has_opaque_alpha(expected)) {
          image::drop_alpha(expected);
          notes_.emplace_back(expected_is_opaque);
        } else if (expected.channels == 3 && actual.channels == 4 &&
                   image::has_opaque_alpha(actual)) {
          image::drop_alpha(actual);
          notes_.emplace_back(actual_is_opaque);
        }
        if (same_format() && expected.channels == 4 &&
            image::copy_hidden_colors(expected, actual)) {
          notes_.emplace_back("the colours of invisible pixels differ");
        }
      },
      images_);
}

bool PicturePair::same_format() const {
  return std::visit(
      [](const auto& pair) {
        const auto& [a, b] = pair;
        return a.width == b.width && a.height == b.height && a.channels == b.channels;
      },
      images_);
}

std::string PicturePair::formats() const {
  return std::visit(
      [](const auto& pair) {
        const auto& [a, b] = pair;
        return fmt::format("{}x{} with {} channels, and {}x{} with {}", a.width, a.height,
                           a.channels, b.width, b.height, b.channels);
      },
      images_);
}

void PicturePair::ignore(std::span<const image::Area> areas) {
  std::visit(
      [&](auto& pair) {
        require_within(areas, pair.first.width, pair.first.height, name_);
        for (const image::Area& area : areas) copy_area(area, pair.first, pair.second);
      },
      images_);
}

image::Difference PicturePair::difference(int threshold, int edges) const {
  return std::visit(
      [&](const auto& pair) { return *image::compare(pair.first, pair.second, threshold, edges); },
      images_);
}

double PicturePair::similarity() const {
  return std::visit(
      [](const auto& pair) { return image::structural_similarity(pair.first, pair.second); },
      images_);
}

image::Image PicturePair::difference_image(int edges) const {
  return std::visit(
      [&](const auto& pair) { return image::difference_image(pair.first, pair.second, edges); },
      images_);
}

}  // namespace twrench::comparison
