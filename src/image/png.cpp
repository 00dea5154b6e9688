#include "image/png.h"

#include <fmt/format.h>
#include <isa-l/crc.h>

#include <algorithm>
#include <limits>
#include <string_view>

#include "base/error.h"
#include "base/file.h"
#include "image/png_bounds.h"
#include "image/stb.h"

namespace twrench {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// The greatest byte first (PNG specification, 7.1).
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

Bytes encoded(const Image& image, const StillPart* still) {
  const auto allowed = [](int side) { return side >= 1 && side <= max_image_side; };
  if (!allowed(image.width) || !allowed(image.height)) {
    throw UsageError(fmt::format("size {}x{}", image.width, image.height),
                     fmt::format("a side must be 1 to {} pixels", max_image_side));
  }
  constexpr std::uint8_t depth = 8, rgb = 2, rgba = 6;  // PNG specification, 11.2.2
  Bytes header;
  add_number(header, static_cast<std::uint32_t>(image.width));
  add_number(header, static_cast<std::uint32_t>(image.height));
  header.insert(header.end(), {depth, image.channels == 4 ? rgba : rgb, 0, 0, 0});
  const Bytes rows = compress_rows(image, still);
  Bytes file{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  file.reserve(rows.size() + 100);
  add_chunk(file, "IHDR", header);
  add_chunk(file, "IDAT", rows);
  add_chunk(file, "IEND", {});
  return file;
}

constexpr std::size_t longest = 1U << 30U;  // of a file that is read

template <typename Sample>
BasicImage<Sample> decoded(std::span<const std::uint8_t> bytes, const std::string& name) {
  const std::string what = "cannot read " + name;
  if (bytes.size() > std::numeric_limits<int>::max()) {
    throw FileError(what, "it is too long for a PNG image");
  }
  if (!can_be_whole_png(bytes)) {
    throw FileError(what, "it is no PNG image, or cut short");
  }
  const PngHeader header = png_header(bytes);
  if (header.width > max_image_side || header.height > max_image_side) {
    throw FileError(what,
                    fmt::format("it is too large: a side has more than {} pixels", max_image_side));
  }
  if (const std::string damage = find_png_damage(bytes); !damage.empty()) {
    throw FileError(what, damage);
  }
  const int channels = header.has_alpha ? 4 : 3;
  const auto pixels = stb::decode_png<Sample>(bytes, channels);
  if (!pixels.data) {
    throw FileError(what, fmt::format("it is no PNG image, or damaged ({})", pixels.failure));
  }
  BasicImage<Sample> image(pixels.width, pixels.height, channels);
  std::copy_n(pixels.data.get(), image.pixels.size(), image.pixels.begin());
  return image;
}

}  // namespace

std::vector<std::uint8_t> encode_png(const Image& image) { return encoded(image, nullptr); }

std::vector<std::uint8_t> encode_png(const Image& image, const StillPart& still) {
  return encoded(image, &still);
}

Image decode_png(std::span<const std::uint8_t> bytes, const std::string& name) {
  return decoded<std::uint8_t>(bytes, name);
}

Image read_png(const std::filesystem::path& path) {
  return decoded<std::uint8_t>(read_file(path, longest), path.string());
}

DeepImage read_deep_png(const std::filesystem::path& path) {
  return decoded<std::uint16_t>(read_file(path, longest), path.string());
}

}  // namespace twrench
