#include "image/png.h"

#include <fmt/format.h>
#include <isa-l/crc.h>
#include <isa-l/igzip_lib.h>
#include <twrench/base/error.h>

#include <algorithm>
#include <array>
#include <new>

#include "image/stb.h"

namespace twrench::image {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr int level = 1;
constexpr std::size_t level_memory = ISAL_DEF_LVL1_DEFAULT;

/// Rows per band. With half as many, files are a percent larger.
constexpr int band_height = 32;
constexpr std::array<std::uint8_t, 2> header{0x78, 0x01};  // RFC 1950, 2.2: deflate, 32 kB, fastest
constexpr std::array<std::uint8_t, 2> last_block{0x03, 0x00};  // RFC 1951, 3.2.6: empty

/// Bytes at the start of a band that are stored without compression and then given to igzip as its
/// dictionary. Without a history, igzip (2.30, 2.31) enters one hash that it computes from the
/// address of its stream instead of the data: one picture in some thousands would have different
/// bytes in another thread or another run.
constexpr std::size_t stored_size = 16;

/// The largest size of a compressed band: incompressible data is stored in blocks of at most 65535
/// bytes with 5 bytes of header each (RFC 1951, 3.2.4), followed by an empty block.
std::size_t most_compressed(std::size_t size) {
  return size + 5 * (size / 65535 + 3) + ISAL_DEF_MAX_HDR_SIZE;
}

/// Stores bytes, at most 65535, as a block without compression (RFC 1951, 3.2.4).
std::size_t store(std::span<const std::uint8_t> bytes, std::uint8_t* block) {
  const auto size = static_cast<unsigned>(bytes.size());
  *block++ = 0;
  for (const unsigned field : {size, ~size}) {
    *block++ = static_cast<std::uint8_t>(field);
    *block++ = static_cast<std::uint8_t>(field >> 8U);
  }
  std::ranges::copy(bytes, block);
  return 5 + bytes.size();
}

/// Compresses the bands of a picture one by one. A band stays in the cache from the filter to the
/// checksum; a whole picture would not.
class BandCompressor {
 public:
  explicit BandCompressor(const Image& image)
      : image_(image),
        filtered_(size_of(band_height)),
        compressed_(most_compressed(size_of(band_height))) {}

  /// Returns the compressed rows, valid until the next call. Call it for all rows in order.
  std::span<const std::uint8_t> operator()(int first_row, int rows) {
    const std::span<std::uint8_t> filtered(filtered_.data(), size_of(rows));
    for (int y = 0; y < rows; ++y) {
      const std::size_t row = static_cast<std::size_t>(first_row + y) * image_.row_bytes();
      stb::filter_row({&image_.pixels[row], image_.row_bytes()}, image_.channels,
                      filtered.subspan(size_of(y), size_of(1)));
    }
    const std::span<const std::uint8_t> bytes = deflate(filtered);
    if (bytes.empty()) throw std::bad_alloc();
    checksum_ = isal_adler32(checksum_, filtered.data(), filtered.size());
    return bytes;
  }

  /// Returns the Adler-32 of the filtered rows so far.
  std::uint32_t checksum() const { return checksum_; }

 private:
  /// Size in bytes of that many filtered rows.
  std::size_t size_of(int rows) const {
    return static_cast<std::size_t>(rows) * (image_.row_bytes() + 1);
  }

  /// Compresses a part of the stream; empty if igzip fails.
  std::span<const std::uint8_t> deflate(std::span<std::uint8_t> rows) {
    const auto first = rows.first(std::min(stored_size, rows.size()));
    const auto rest = rows.subspan(first.size());
    const std::size_t stored = store(first, compressed_.data());
    if (rest.empty()) return {compressed_.data(), stored};
    isal_deflate_init(&stream_);
    stream_.level = level;
    stream_.level_buf = level_memory_.data();
    stream_.level_buf_size = level_memory;
    stream_.flush = FULL_FLUSH;
    stream_.next_in = rest.data();
    stream_.avail_in = static_cast<std::uint32_t>(rest.size());
    stream_.next_out = compressed_.data() + stored;
    stream_.avail_out = static_cast<std::uint32_t>(compressed_.size() - stored);
    const bool done = isal_deflate_set_dict(&stream_, first.data(),
                                            static_cast<std::uint32_t>(first.size())) == COMP_OK &&
                      isal_deflate(&stream_) == COMP_OK && stream_.avail_in == 0 &&
                      stream_.avail_out > 0;
    return {compressed_.data(), done ? stored + stream_.total_out : 0};
  }

  const Image& image_;
  std::uint32_t checksum_ = 1;
  std::vector<std::uint8_t> filtered_;
  std::vector<std::uint8_t> compressed_;
  std::vector<std::uint8_t> level_memory_ = std::vector<std::uint8_t>(level_memory);
  isal_zstream stream_{};  // igzip's initialisation leaves some fields unset that it reads
};

/// Appends the number, most significant byte first (PNG specification, 7.1).
void add_number(Bytes& file, std::uint32_t value) {
  for (const int shift : {24, 16, 8, 0}) file.push_back(static_cast<std::uint8_t>(value >> shift));
}

/// Returns the zlib stream (RFC 1950) of an image's filtered rows, compressed by ISA-L's igzip.
Bytes compress_rows(const Image& image) {
  BandCompressor compress(image);
  Bytes stream(header.begin(), header.end());
  for (int row = 0; row < image.height; row += band_height) {
    const auto bytes = compress(row, std::min(band_height, image.height - row));
    stream.insert(stream.end(), bytes.begin(), bytes.end());
  }
  stream.insert(stream.end(), last_block.begin(), last_block.end());
  add_number(stream, compress.checksum());
  return stream;
}

/// PNG specification, 5.3.
void add_chunk(Bytes& file, std::string_view type, std::span<const std::uint8_t> data) {
  add_number(file, static_cast<std::uint32_t>(data.size()));
  const std::size_t checked = file.size();
  file.insert(file.end(), type.begin(), type.end());
  file.insert(file.end(), data.begin(), data.end());
  add_number(file, crc32_gzip_refl(0, &file[checked], file.size() - checked));
}

}  // namespace

std::vector<std::uint8_t> encode_png(const Image& image, std::string_view software) {
  const auto allowed = [](int side) { return side >= 1 && side <= max_image_side; };
  if (!allowed(image.width) || !allowed(image.height)) {
    throw InvalidArgument(fmt::format("size {}x{}", image.width, image.height),
                          fmt::format("a side must be 1 to {} pixels", max_image_side));
  }
  constexpr std::uint8_t depth = 8, rgb = 2, rgba = 6;  // PNG specification, 11.2.2
  Bytes header;
  add_number(header, static_cast<std::uint32_t>(image.width));
  add_number(header, static_cast<std::uint32_t>(image.height));
  header.insert(header.end(), {depth, image.channels == 4 ? rgba : rgb, 0, 0, 0});
  const Bytes rows = compress_rows(image);
  Bytes file{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  file.reserve(rows.size() + 100);
  add_chunk(file, "IHDR", header);
  if (!software.empty()) {
    constexpr std::string_view keyword{"Software\0", 9};  // PNG specification, 11.3.4.2
    Bytes text(keyword.begin(), keyword.end());
    text.insert(text.end(), software.begin(), software.end());
    add_chunk(file, "tEXt", text);
  }
  add_chunk(file, "IDAT", rows);
  add_chunk(file, "IEND", {});
  return file;
}

}  // namespace twrench::image
