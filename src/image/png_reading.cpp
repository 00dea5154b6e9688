#include <fmt/format.h>
#include <isa-l/igzip_lib.h>
#include <spng.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <new>
#include <string_view>
#include <utility>

#include "image/image.h"
#include "image/plain_png.h"
#include "image/png.h"
#include "image/png_chunks.h"
#include "system/error.h"
#include "system/file.h"
#include "system/file_kind.h"

namespace twrench::image {
namespace {

using ByteSpan = std::span<const std::uint8_t>;

/// The maximum size of inflated texts, colour profiles and the like, which libspng keeps while it
/// decodes.
constexpr std::size_t max_metadata_mebibytes = 64;

std::string explanation(int code) {
  switch (code) {
    case SPNG_EIHDR_SIZE:
    case SPNG_ENOIHDR:
      return "it has no header of a PNG image";
    case SPNG_IO_EOF:
      return "it is truncated";
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

int error_of(ChunkState state) {
  switch (state) {
    case ChunkState::whole:
      return SPNG_OK;
    case ChunkState::no_png:
    case ChunkState::cut_short:
      return SPNG_IO_EOF;
    case ChunkState::wrong_checksum:
      break;
  }
  return SPNG_ECHUNK_CRC;
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
    require_png(file, name);
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
    if (size > most_from_a_byte * file_.size()) check(SPNG_IO_EOF);
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

Image decode_png(std::span<const std::uint8_t> bytes, const std::string& name,
                 std::vector<std::uint8_t> memory) {
  if (auto image = decode_plain_png(bytes, std::move(memory))) return std::move(*image);
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
  const int error = error_of(check_chunks(bytes));
  if (error != SPNG_OK) throw system::FileError("cannot read " + name, explanation(error));
}

Image read_png(const std::filesystem::path& path) {
  return decode_png(system::read_file(path, max_png_size), path.string());
}

}  // namespace twrench::image
