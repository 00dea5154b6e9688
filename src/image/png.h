#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "image/image.h"
#include "system/error.h"

namespace twrench::image {

/// The largest width and height that is read or written, which is also that of llvmpipe's
/// framebuffers.
constexpr int max_image_side = 16384;

/// Returns the image as a PNG file (8 bits per channel, not interlaced). Equal images give equal
/// bytes. `software` names the program that wrote it; empty for a frame. Thread-safe. Throws
/// InvalidArgument if a side is not 1 to max_image_side.
std::vector<std::uint8_t> encode_png(const Image& image, std::string_view software = {});

/// Decodes a PNG file, as RGBA if anything can be transparent, otherwise as RGB; gray becomes RGB,
/// and 16 bits become 8. `name` names the file in errors. Throws FileError if the file is not a
/// PNG, is too large, or is damaged; all its checksums are verified.
Image decode_png(std::span<const std::uint8_t> bytes, const std::string& name);

/// Like decode_png(), but keeps all 16 bits of a channel; 8 bits become 16.
DeepImage decode_deep_png(std::span<const std::uint8_t> bytes, const std::string& name);

/// The header of a PNG file.
struct PngHeader {
  std::uint32_t width = 0, height = 0;
  int bit_depth = 0;
};

/// Returns the header of a PNG file without checking it; it is meaningless for other bytes.
PngHeader png_header(std::span<const std::uint8_t> bytes);

/// Throws FileError unless the bytes begin like a PNG file. The message names what they are
/// instead.
void require_png(std::span<const std::uint8_t> bytes, const std::string& name);

/// Throws FileError as decode_png() does unless the bytes are a PNG file whose chunks are complete
/// and have correct checksums. Takes a hundredth of the time of decoding.
void require_whole_png(std::span<const std::uint8_t> bytes, const std::string& name);

/// The maximum size in bytes of a file that is read.
constexpr std::size_t max_png_size = 1U << 30U;

/// Reads an image from a file. Throws FileError if it cannot be read, and as decode_png() does.
Image read_png(const std::filesystem::path& path);

// The chunk structure of PNG files (PNG specification, 5).

/// The state of the chunks of a file.
enum class ChunkState { whole, no_png, cut_short, wrong_checksum };

/// Checks that a file consists of chunks with correct checksums up to its end.
ChunkState check_chunks(std::span<const std::uint8_t> file);

/// A chunk of a file.
struct Chunk {
  std::string_view type;
  std::span<const std::uint8_t> data;
};

/// Returns the chunks of a file, whose state must be `whole`.
std::vector<Chunk> chunks_of(std::span<const std::uint8_t> file);

/// Returns the types of the chunks that describe colours (gAMA, iCCP, ...) and differ between two
/// files; a file without a chunk differs from one with it. The state of both must be `whole`.
std::vector<std::string_view> different_color_chunks(std::span<const std::uint8_t> a,
                                                     std::span<const std::uint8_t> b);

/// Returns the number in four bytes, the most significant first (PNG specification, 7.1).
std::uint32_t png_number(std::span<const std::uint8_t> bytes, std::size_t at);

}  // namespace twrench::image
