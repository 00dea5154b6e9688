#include "image/png_chunks.h"

#include <isa-l/crc.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

namespace twrench::image {
namespace {

constexpr std::array<std::uint8_t, 8> signature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
constexpr std::size_t around_data = 12;  // a chunk's length, type and checksum

}  // namespace

std::uint32_t png_number(std::span<const std::uint8_t> bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (const std::uint8_t byte : bytes.subspan(at, 4)) value = value << 8U | byte;
  return value;
}

ChunkState check_chunks(std::span<const std::uint8_t> file) {
  const auto begin = file.first(std::min(file.size(), signature.size()));
  if (!std::ranges::equal(begin, signature)) return ChunkState::no_png;
  for (std::size_t at = signature.size(); at + around_data <= file.size();) {
    const std::size_t length = png_number(file, at);
    if (length > file.size() - at - around_data) return ChunkState::cut_short;
    const auto checked = file.subspan(at + 4, length + 4);  // type and data
    if (crc32_gzip_refl(0, checked.data(), checked.size()) != png_number(file, at + 8 + length)) {
      return ChunkState::wrong_checksum;
    }
    at += length + around_data;
    if (std::ranges::equal(checked.first(4), std::string_view("IEND"))) return ChunkState::whole;
  }
  return ChunkState::cut_short;
}

std::vector<Chunk> chunks_of(std::span<const std::uint8_t> file) {
  std::vector<Chunk> chunks;
  for (std::size_t at = signature.size(); chunks.empty() || chunks.back().type != "IEND";) {
    const std::size_t length = png_number(file, at);
    chunks.push_back(
        {{reinterpret_cast<const char*>(&file[at + 4]), 4}, file.subspan(at + 8, length)});
    at += length + around_data;
  }
  return chunks;
}

std::vector<std::string_view> different_color_chunks(std::span<const std::uint8_t> a,
                                                     std::span<const std::uint8_t> b) {
  const std::vector<Chunk> chunks_of_a = chunks_of(a), chunks_of_b = chunks_of(b);
  const auto data = [](const std::vector<Chunk>& chunks, std::string_view type) {
    const auto found = std::ranges::find(chunks, type, &Chunk::type);
    return found == chunks.end() ? std::optional<std::span<const std::uint8_t>>() : found->data;
  };
  std::vector<std::string_view> types;
  for (const std::string_view type : {"gAMA", "cHRM", "sRGB", "iCCP", "cICP"}) {
    const auto of_a = data(chunks_of_a, type), of_b = data(chunks_of_b, type);
    const bool is_equal = of_a && of_b ? std::ranges::equal(*of_a, *of_b) : !of_a && !of_b;
    if (!is_equal) types.push_back(type);
  }
  return types;
}

}  // namespace twrench::image
