#include "image/png_bounds.h"

#include <cstddef>

namespace twrench {
namespace {

constexpr std::size_t signature = 8;  // bytes before the first chunk

/// Four bytes, the greatest first (PNG specification, 2.1).
std::uint64_t number_at(std::span<const std::uint8_t> file, std::size_t at) {
  std::uint64_t value = 0;
  for (const std::uint8_t byte : file.subspan(at, 4)) value = value << 8U | byte;
  return value;
}

/// Whether every chunk up to IEND ends within the file. One of data that has none is refused too:
/// legal, but written by nobody, and stb_image copies from a null pointer for it.
bool has_all_chunks(std::span<const std::uint8_t> file) {
  constexpr std::size_t around = 12;          // a chunk's length, type and checksum
  constexpr std::uint64_t last = 0x49454E44;  // "IEND"
  constexpr std::uint64_t data = 0x49444154;  // "IDAT"
  for (std::size_t at = signature; file.size() - at >= around;) {
    const std::uint64_t length = number_at(file, at);
    if (length > file.size() - at - around) return false;
    const std::uint64_t type = number_at(file, at + 4);
    if (type == last) return true;
    if (type == data && length == 0) return false;
    at += around + static_cast<std::size_t>(length);
  }
  return false;
}

}  // namespace

bool can_be_whole_png(std::span<const std::uint8_t> file) {
  constexpr std::size_t width_at = signature + 8;  // IHDR comes first
  constexpr std::size_t height_at = width_at + 4;
  if (file.size() < height_at + 4 || !has_all_chunks(file)) return false;
  // A pixel has a bit or more, and deflate makes at best 258 bytes of 2 bits (RFC 1951, 3.2.5).
  constexpr std::uint64_t most_from_a_byte = 1032;
  const std::uint64_t width = number_at(file, width_at);
  const std::uint64_t height = number_at(file, height_at);
  return (width + 7) / 8 * height <= most_from_a_byte * file.size();
}

}  // namespace twrench
