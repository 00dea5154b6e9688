#include <fmt/format.h>
#include <isa-l/crc.h>
#include <isa-l/igzip_lib.h>
#include <spng.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "image/image.h"
#include "image/png.h"
#include "system/error.h"
#include "system/file.h"
#include "system/file_kind.h"

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

/// Decodes a PNG file of the kind that encode_png() and many other programs write: 8 bits of RGB or
/// RGBA, row after row, without filters that need more than one neighbour. Returns nothing for any
/// other file and for a damaged one; use libspng for these. ISA-L inflates the data once and to
/// their end; libspng takes as long as zlib and does not read the end.
std::optional<Image> decode_plain_png(std::span<const std::uint8_t> file) {
  constexpr std::size_t most_from_a_byte = 1032;  // RFC 1951, 3.2.5: 258 bytes of 2 bits
  if (check_chunks(file) != ChunkState::whole) return {};
  const std::vector<Chunk> chunks = chunks_of(file);
  std::optional<Image> image = plain_format(chunks.front());
  const auto pieces = plain_data(std::span(chunks).subspan(1));
  if (!image || pieces.empty()) return {};
  const std::size_t size = (image->row_bytes() + 1) * static_cast<std::size_t>(image->height);
  if (size > most_from_a_byte * file.size()) return {};
  // One byte more, because ISA-L does not look for the end of the data when the output is full.
  image->pixels.resize(size + 1);
  if (!inflate_rows(pieces, image->pixels) || !undo_filters(*image)) return {};
  return image;
}

using ByteSpan = std::span<const std::uint8_t>;

/// Returns how many bytes are missing at least at the end of a file whose chunks are cut short. The
/// sizes of later chunks are not known.
std::size_t missing_bytes(ByteSpan file) {
  for (std::size_t at = signature.size();;) {
    std::size_t end = at + around_data;
    if (end <= file.size()) end += png_number(file, at);
    if (end > file.size()) return end - file.size();
    at = end;
  }
}

/// The maximum size of inflated texts, colour profiles and the like, which libspng keeps while it
/// decodes.
constexpr std::size_t max_metadata_mebibytes = 64;

std::string explanation(int code) {
  switch (code) {
    case SPNG_EIHDR_SIZE:
    case SPNG_ENOIHDR:
      return "it has no header of a PNG image";
    case SPNG_EUSER_WIDTH:
    case SPNG_EUSER_HEIGHT:
      return fmt::format("it is too large: a side has more than {} pixels", max_image_side);
    case SPNG_ECHUNK_CRC:
      return "the checksum of a chunk is wrong";
    case SPNG_ECHUNK_LIMITS:
      return fmt::format("its metadata are too large: more than {} MiB, or 1000 chunks",
                         max_metadata_mebibytes);
    case SPNG_EIDAT_STREAM:
      return "its compressed data are damaged";
    case SPNG_EIDAT_TOO_SHORT:
      return "its compressed data are truncated";
    default:
      return fmt::format("it is damaged ({})", spng_strerror(code));
  }
}

/// The pieces of compressed data in a file whose chunks are known to be whole.
std::vector<ByteSpan> compressed_data(ByteSpan file) {
  std::vector<ByteSpan> pieces;
  for (const Chunk& chunk : chunks_of(file)) {
    if (chunk.type == "IDAT") pieces.push_back(chunk.data);
  }
  return pieces;
}

/// Inflates the data once more, to at most `most` bytes, and returns the error as a code of
/// libspng. libspng stops at the last pixel, so that it overlooks data that go on, end early, or
/// have another Adler-32. Bytes after their end are ignored, as by other decoders.
int end_error(const std::vector<ByteSpan>& pieces, std::uint64_t most) {
  const auto state = std::make_unique<inflate_state>();
  const auto dropped = std::make_unique<std::array<std::uint8_t, 1 << 16>>();
  isal_inflate_init(state.get());
  state->crc_flag = ISAL_ZLIB;
  std::uint64_t size = 0;
  for (const ByteSpan piece : pieces) {
    state->next_in = const_cast<std::uint8_t*>(piece.data());  // it is only read
    state->avail_in = static_cast<std::uint32_t>(piece.size());
    do {
      state->next_out = dropped->data();
      state->avail_out = static_cast<std::uint32_t>(dropped->size());
      if (isal_inflate(state.get()) != ISAL_DECOMP_OK) return SPNG_EIDAT_STREAM;
      size += dropped->size() - state->avail_out;
      if (size > most) return SPNG_EIDAT_STREAM;
      if (state->block_state == ISAL_BLOCK_FINISH) return SPNG_OK;
    } while (state->avail_in > 0 || state->avail_out == 0);
  }
  return SPNG_EIDAT_TOO_SHORT;
}

/// A PNG file that libspng decodes. Every member throws FileError, or std::bad_alloc.
class Decoder {
 public:
  Decoder(ByteSpan file, const std::string& name) : file_(file), what_("cannot read " + name) {
    if (!context_) throw std::bad_alloc();
    require_whole_png(file, name);
    constexpr std::size_t max_metadata = max_metadata_mebibytes << 20U;
    check(spng_set_image_limits(context_.get(), max_image_side, max_image_side));
    check(spng_set_chunk_limits(context_.get(), max_metadata, max_metadata));
    check(spng_set_crc_action(context_.get(), SPNG_CRC_ERROR, SPNG_CRC_ERROR));
    check(spng_set_png_buffer(context_.get(), file.data(), file.size()));
    check(spng_get_ihdr(context_.get(), &header_));
    check_size();
  }

  int width() const { return static_cast<int>(header_.width); }
  int height() const { return static_cast<int>(header_.height); }

  /// Returns whether anything can be transparent, by an alpha channel or by transparent colours or
  /// palette entries.
  bool has_alpha() {
    spng_trns transparency{};
    const int code = spng_get_trns(context_.get(), &transparency);
    if (code != SPNG_ECHUNKAVAIL) check(code);
    return code == SPNG_OK || header_.color_type == SPNG_COLOR_TYPE_GRAYSCALE_ALPHA ||
           header_.color_type == SPNG_COLOR_TYPE_TRUECOLOR_ALPHA;
  }

  /// Decodes the pixels, and reads the file to its end.
  template <typename Sample>
  void decode(std::vector<Sample>& pixels, spng_format format) {
    check(spng_decode_image(context_.get(), pixels.data(), pixels.size() * sizeof(Sample), format,
                            SPNG_DECODE_TRNS));
    check(spng_decode_chunks(context_.get()));
    // A pixel has at most 8 bytes, and a row has one byte for its filter. In an interlaced image
    // each of the seven passes has its own rows, for whose filters 16 bytes per row are more than
    // enough.
    const std::uint64_t most = (std::uint64_t{8} * header_.width + 16) * header_.height;
    check(end_error(compressed_data(file_), most));
  }

 private:
  void check(int code) const {
    if (code == SPNG_EMEM || code == SPNG_EZLIB_INIT) throw std::bad_alloc();
    if (code != SPNG_OK) throw system::FileError(what_, explanation(code));
  }

  /// Rejects a size for which the file is too short. libspng would find that only after the pixels'
  /// memory is allocated, and a few bytes could request gigabytes.
  void check_size() const {
    constexpr std::size_t most_from_a_byte =
        1032;  // deflate: 258 bytes of 2 bits (RFC 1951, 3.2.5)
    std::size_t size = 0;
    check(spng_decoded_image_size(context_.get(), SPNG_FMT_RAW, &size));
    if (size > most_from_a_byte * file_.size()) check(SPNG_EIDAT_TOO_SHORT);
  }

  struct Free {
    void operator()(spng_ctx* context) const noexcept { spng_ctx_free(context); }
  };

  ByteSpan file_;
  std::string what_;
  // end_error() verifies the Adler-32 of the data.
  std::unique_ptr<spng_ctx, Free> context_{spng_ctx_new(SPNG_CTX_IGNORE_ADLER32)};
  spng_ihdr header_{};
};

Image decode_8_bits(Decoder& decoder) {
  const bool has_alpha = decoder.has_alpha();
  Image image(decoder.width(), decoder.height(), has_alpha ? 4 : 3);
  decoder.decode(image.pixels, has_alpha ? SPNG_FMT_RGBA8 : SPNG_FMT_RGB8);
  return image;
}

DeepImage decode_16_bits(Decoder& decoder) {
  const bool has_alpha = decoder.has_alpha();
  DeepImage image(decoder.width(), decoder.height(), 4);
  decoder.decode(image.pixels, SPNG_FMT_RGBA16);  // libspng has no RGB of 16 bits
  if (!has_alpha) drop_alpha(image);
  return image;
}

/// libspng can widen as well, but then reading as a whole takes half as long again.
DeepImage widened(const Image& image) {
  DeepImage wide(image.width, image.height, image.channels);
  std::ranges::transform(image.pixels, wide.pixels.begin(), [](std::uint8_t sample) {
    return static_cast<std::uint16_t>(sample * 0x101);
  });
  return wide;
}

}  // namespace

Image decode_png(std::span<const std::uint8_t> bytes, const std::string& name) {
  if (auto image = decode_plain_png(bytes)) return std::move(*image);
  Decoder decoder(bytes, name);
  return decode_8_bits(decoder);
}

DeepImage decode_deep_png(std::span<const std::uint8_t> bytes, const std::string& name) {
  if (png_header(bytes).bit_depth != 16) return widened(decode_png(bytes, name));
  Decoder decoder(bytes, name);
  return decode_16_bits(decoder);
}

PngHeader png_header(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t width = 16, height = 20, bit_depth = 24;  // PNG specification, 5.3, 11.2.2
  if (bytes.size() <= bit_depth) return {};
  return {png_number(bytes, width), png_number(bytes, height), bytes[bit_depth]};
}

void require_png(std::span<const std::uint8_t> bytes, const std::string& name) {
  constexpr std::string_view signature = "\x89PNG\r\n\x1A\n";
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const bool is_cut = !text.empty() && signature.starts_with(text);
  if (is_cut || text.starts_with(signature)) return;
  const auto kind = system::recognized_file_kind(text);
  throw system::FileError(
      "cannot read " + name,
      kind ? fmt::format("it is {}, not a PNG image", *kind) : "it is not a PNG image",
      "name a PNG image, or convert this file to one");
}

void require_whole_png(std::span<const std::uint8_t> bytes, const std::string& name) {
  require_png(bytes, name);
  const std::string what = "cannot read " + name;
  switch (check_chunks(bytes)) {
    case ChunkState::whole:
      return;
    case ChunkState::no_png:  // because the signature itself is cut off
    case ChunkState::cut_short:
      throw system::FileError(what,
                              fmt::format("it is cut off: at least {} bytes are missing at its end",
                                          missing_bytes(bytes)));
    case ChunkState::wrong_checksum:
      break;
  }
  throw system::FileError(what, explanation(SPNG_ECHUNK_CRC));
}

Image read_png(const std::filesystem::path& path) {
  return decode_png(system::read_file(path, max_png_size), path.string());
}

}  // namespace twrench::image
