#include "image/png.h"

#include <fmt/format.h>
#include <isa-l/crc.h>
#include <twrench/base/error.h>

#include <string_view>

namespace twrench::image {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// Appends the number, most significant byte first (PNG specification, 7.1).
void add_number(Bytes& file, std::uint32_t value) {
  for (const int shift : {24, 16, 8, 0}) file.push_back(static_cast<std::uint8_t>(value >> shift));
}

/// PNG specification, 5.3.
void add_chunk(Bytes& file, std::string_view type, std::span<const std::uint8_t> data) {
  add_number(file, static_cast<std::uint32_t>(data.size()));
  const std::size_t checked = file.size();
  file.insert(file.end(), type.begin(), type.end());
  file.insert(file.end(), data.begin(), data.end());
  add_number(file, crc32_gzip_refl(0, &file[checked], file.size() - checked));
}

Bytes encoded(const Image& image, const StaticPart* background, std::string_view software) {
  const auto allowed = [](int side) { return side >= 1 && side <= max_image_side; };
  if (!allowed(image.width) || !allowed(image.height)) {
    throw InvalidArgument(fmt::format("size {}x{}", image.width, image.height),
                          fmt::format("a side must be 1 to {} pixels", max_image_side));
  }
  constexpr std::uint8_t depth = 8, rgb = 2, rgba = 6;  // PNG specification, 11.2.2
  Bytes header;
  add_number(header, static_cast<std::uint32_t>(image.width));
  add_number(header, static_cast<std::uint32_t>(image.height));
  header.insert(header.end(), {depth, image.channels == 4 ? rgba : rgb, 0, 0, 0});
  const Bytes rows = compress_rows(image, background);
  Bytes file{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  file.reserve(rows.size() + 100);
  add_chunk(file, "IHDR", header);
  if (!software.empty()) {
    constexpr std::string_view keyword{"Software\0", 9};  // PNG specification, 11.3.4.2
    Bytes text(keyword.begin(), keyword.end());
    text.insert(text.end(), software.begin(), software.end());
    add_chunk(file, "tEXt", text);
  }
  add_chunk(file, "IDAT", rows);
  add_chunk(file, "IEND", {});
  return file;
}

}  // namespace

std::vector<std::uint8_t> encode_png(const Image& image, std::string_view software) {
  return encoded(image, nullptr, software);
}

std::vector<std::uint8_t> encode_png(const Image& image, const StaticPart& background) {
  return encoded(image, &background, {});
}

}  // namespace twrench::image
