#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace twrench::image {

// The outer form of a PNG file (PNG specification, 5).

/// What the chunks of a file are like.
enum class ChunkState { whole, no_png, cut_short, wrong_checksum };

/// Whether a file consists of chunks with the right checksums, up to its end.
ChunkState check_chunks(std::span<const std::uint8_t> file);

/// A chunk of a file.
struct Chunk {
  std::string_view type;
  std::span<const std::uint8_t> data;
};

/// The chunks of a file that are known to be whole.
std::vector<Chunk> chunks_of(std::span<const std::uint8_t> file);

/// Four bytes, the greatest first (PNG specification, 7.1).
std::uint32_t png_number(std::span<const std::uint8_t> bytes, std::size_t at);

}  // namespace twrench::image
