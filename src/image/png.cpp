#include "image/png.h"

#include <fmt/format.h>

#include <cstring>
#include <limits>
#include <new>

#include "base/error.h"
#include "base/file.h"
#include "image/png_bounds.h"
#include "image/stb.h"

namespace twrench {
namespace {

std::vector<std::uint8_t> encoded(const Image& image, const StillPart* still) {
  const auto allowed = [](int side) { return side >= 1 && side <= max_image_side; };
  if (!allowed(image.width) || !allowed(image.height)) {
    throw UsageError(fmt::format("size {}x{}", image.width, image.height),
                     fmt::format("a side must be 1 to {} pixels", max_image_side));
  }
  const stb::Bytes png = stb::encode_png(image.pixels.data(), image.width, image.height,
                                         image.channels, [&](std::span<const std::uint8_t> rows) {
                                           return compress_rows(rows, image.row_bytes() + 1, still);
                                         });
  if (!png.data) {
    throw std::bad_alloc();
  }
  return {png.data.get(), png.data.get() + png.size};
}

}  // namespace

std::vector<std::uint8_t> encode_png(const Image& image) { return encoded(image, nullptr); }

std::vector<std::uint8_t> encode_png(const Image& image, const StillPart& still) {
  return encoded(image, &still);
}

Image decode_png(std::span<const std::uint8_t> bytes, const std::string& name) {
  const std::string what = "cannot read " + name;
  if (bytes.size() > std::numeric_limits<int>::max()) {
    throw FileError(what, "it is too long for a PNG image");
  }
  if (!can_be_whole_png(bytes)) {
    throw FileError(what, "it is no PNG image, or cut short");
  }
  const stb::Pixels pixels = stb::decode_png(bytes, max_image_side);
  if (!pixels.data) {
    throw FileError(what, fmt::format("it is no PNG image, or damaged ({})", pixels.failure));
  }
  Image image(pixels.width, pixels.height, pixels.channels);
  std::memcpy(image.pixels.data(), pixels.data.get(), image.pixels.size());
  return image;
}

Image read_png(const std::filesystem::path& path) {
  constexpr std::size_t longest = 1U << 30U;
  return decode_png(read_file(path, longest), path.string());
}

}  // namespace twrench
