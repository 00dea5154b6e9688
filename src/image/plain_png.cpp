#include "image/plain_png.h"

#include <isa-l/igzip_lib.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "image/png.h"
#include "image/png_chunks.h"

namespace twrench::image {
namespace {

using Bytes = std::vector<std::uint8_t>;

enum Filter : std::uint8_t { none = 0, sub = 1, up = 2 };  // PNG specification, 9.2

/// Returns an image without pixels in the format of the header; nothing if that is another format.
std::optional<Image> plain_format(const Chunk& chunk) {
  constexpr std::size_t header_size = 13;
  constexpr std::uint8_t depth = 8, rgb = 2, rgba = 6;
  if (chunk.type != "IHDR" || chunk.data.size() != header_size) return {};
  const auto allowed = [](std::uint32_t side) { return side >= 1 && side <= max_image_side; };
  const std::uint32_t width = png_number(chunk.data, 0), height = png_number(chunk.data, 4);
  const std::uint8_t color_type = chunk.data[9];
  const bool is_plain = chunk.data[8] == depth && (color_type == rgb || color_type == rgba);
  const bool is_standard = chunk.data[10] == 0 && chunk.data[11] == 0 && chunk.data[12] == 0;
  if (!is_plain || !is_standard || !allowed(width) || !allowed(height)) return {};
  Image format;
  format.width = static_cast<int>(width);
  format.height = static_cast<int>(height);
  format.channels = color_type == rgba ? 4 : 3;
  return format;
}

/// Returns the compressed data; nothing if the file has any chunk besides the header, the data, the
/// end and the physical size of a pixel.
std::vector<std::span<const std::uint8_t>> plain_data(std::span<const Chunk> chunks) {
  std::vector<std::span<const std::uint8_t>> pieces;
  for (const Chunk& chunk : chunks) {
    const bool is_pixel_size = pieces.empty() && chunk.type == "pHYs" && chunk.data.size() == 9;
    if (chunk.type == "IDAT") {
      pieces.push_back(chunk.data);
    } else if (chunk.type == "IEND" ? !chunk.data.empty() : !is_pixel_size) {
      return {};
    }
  }
  return pieces;
}

/// Inflates data that fill `rows` except for the last byte, and verifies the checksum of the
/// stream.
bool inflate_rows(std::span<const std::span<const std::uint8_t>> pieces, Bytes& rows) {
  const auto state = std::make_unique<inflate_state>();
  isal_inflate_init(state.get());
  state->crc_flag = ISAL_ZLIB;
  state->next_out = rows.data();
  state->avail_out = static_cast<std::uint32_t>(rows.size());
  for (const std::span<const std::uint8_t> piece : pieces) {
    state->next_in = const_cast<std::uint8_t*>(piece.data());  // it is only read
    state->avail_in = static_cast<std::uint32_t>(piece.size());
    if (isal_inflate(state.get()) != ISAL_DECOMP_OK) return false;
    if (state->block_state == ISAL_BLOCK_FINISH) return state->avail_out == 1;
  }
  return false;
}

/// Each sample is stored as the difference from the sample on its left, which is kept in registers.
template <std::size_t channels>
void undo_sub(std::span<std::uint8_t> row) {
  std::array<std::uint8_t, channels> left{};
  for (std::size_t i = 0; i < row.size(); i += channels) {
    for (std::size_t c = 0; c < channels; ++c) {
      left[c] = static_cast<std::uint8_t>(left[c] + row[i + c]);
      row[i + c] = left[c];
    }
  }
}

/// Each sample is stored as the difference from the sample above.
void undo_up(std::span<std::uint8_t> row, const std::uint8_t* above) {
  for (std::size_t i = 0; i < row.size(); ++i) {
    row[i] = static_cast<std::uint8_t>(row[i] + above[i]);
  }
}

/// Turns rows with a filter byte each into pixels, in place: every row moves towards the beginning
/// by the number of filter bytes up to it.
bool undo_filters(Image& image) {
  const std::size_t size = image.row_bytes();
  std::uint8_t* pixels = image.pixels.data();
  const std::uint8_t* filtered = pixels;
  for (int y = 0; y < image.height; ++y, filtered += size + 1, pixels += size) {
    const std::uint8_t filter = *filtered;
    std::copy_n(filtered + 1, size, pixels);
    const std::span row(pixels, size);
    if (filter == sub) {
      image.channels == 3 ? undo_sub<3>(row) : undo_sub<4>(row);
    } else if (filter == up) {
      if (y > 0) undo_up(row, pixels - size);
    } else if (filter != none) {
      return false;
    }
  }
  image.pixels.resize(size * static_cast<std::size_t>(image.height));
  return true;
}

}  // namespace

std::optional<Image> decode_plain_png(std::span<const std::uint8_t> file,
                                      std::vector<std::uint8_t> memory) {
  constexpr std::size_t most_from_a_byte = 1032;  // RFC 1951, 3.2.5: 258 bytes of 2 bits
  if (check_chunks(file) != ChunkState::whole) return {};
  const std::vector<Chunk> chunks = chunks_of(file);
  std::optional<Image> image = plain_format(chunks.front());
  const auto pieces = plain_data(std::span(chunks).subspan(1));
  if (!image || pieces.empty()) return {};
  const std::size_t size = (image->row_bytes() + 1) * static_cast<std::size_t>(image->height);
  if (size > most_from_a_byte * file.size()) return {};
  // One byte more, because ISA-L does not look for the end of the data when the output is full.
  image->pixels = std::move(memory);
  image->pixels.resize(size + 1);
  if (!inflate_rows(pieces, image->pixels) || !undo_filters(*image)) return {};
  return image;
}

}  // namespace twrench::image
