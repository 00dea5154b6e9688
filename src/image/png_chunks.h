#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace twrench::image {

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
