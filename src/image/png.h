#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "image/image.h"
#include "image/row_bands.h"
#include "system/error.h"

namespace twrench::image {

/// The largest width and height that is read or written; llvmpipe's largest framebuffer too.
constexpr int max_image_side = 16384;

/// The image as a PNG file (8 bits a channel, not interlaced). The same image gives the same bytes.
/// May be called from several threads at once. Throws InvalidArgument when a side is not 1 to
/// max_image_side.
std::vector<std::uint8_t> encode_png(const Image& image);

/// The same bytes, for less where `still` tells that rows are those of other frames of a film.
std::vector<std::uint8_t> encode_png(const Image& image, const StaticPart& background);

/// The image in the bytes of a PNG file: RGB, or RGBA where anything can be transparent; gray
/// becomes RGB, 16 bits become 8. `name` names it in errors. Throws FileError when it is no PNG, is
/// too large, or is damaged, which all its checksums are asked for. `memory`, the pixels of an
/// image that is no longer needed, is used again: the system need not clear pages for each image.
Image decode_png(std::span<const std::uint8_t> bytes, const std::string& name,
                 std::vector<std::uint8_t> memory = {});

/// The same with all 16 bits of a channel; 8 bits become 16.
DeepImage decode_deep_png(std::span<const std::uint8_t> bytes, const std::string& name);

/// What a PNG file says of itself at its beginning.
struct PngHeader {
  std::uint32_t width = 0, height = 0;
  int bit_depth = 0;
};

/// Returns the header of a PNG file, unchecked: of other bytes it means nothing.
PngHeader png_header(std::span<const std::uint8_t> bytes);

/// Throws FileError, as decode_png does, unless the bytes are a PNG file whose chunks are whole by
/// their checksums. Takes a hundredth of the time of decoding.
void require_whole_png(std::span<const std::uint8_t> bytes, const std::string& name);

/// The largest size in bytes of a file that is read.
constexpr std::size_t max_png_size = 1U << 30U;

/// The image in the file. Throws FileError when it cannot be read, and as decode_png.
Image read_png(const std::filesystem::path& path);

}  // namespace twrench::image
