#include "image/row_bands.h"

#include <isa-l/igzip_lib.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <new>

#include "image/stb.h"

namespace twrench::image {
namespace {

constexpr int level = 1;
constexpr std::size_t level_memory = ISAL_DEF_LVL1_DEFAULT;

/// Rows per band. With half as many, files are a percent larger; with twice as many, fewer are
/// static.
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

  /// Size in bytes of that many filtered rows.
  std::size_t size_of(int rows) const {
    return static_cast<std::size_t>(rows) * (image_.row_bytes() + 1);
  }

  /// The compressed rows, valid until the next call.
  struct Result {
    std::span<const std::uint8_t> bytes;
    std::uint32_t checksum;
  };
  Result operator()(int first_row, int rows) {
    const std::span<std::uint8_t> filtered(filtered_.data(), size_of(rows));
    for (int y = 0; y < rows; ++y) {
      const std::size_t row = static_cast<std::size_t>(first_row + y) * image_.row_bytes();
      stb::filter_row({&image_.pixels[row], image_.row_bytes()}, image_.channels,
                      filtered.subspan(size_of(y), size_of(1)));
    }
    const std::span<const std::uint8_t> bytes = deflate(filtered);
    if (bytes.empty()) throw std::bad_alloc();
    return {bytes, isal_adler32(1, filtered.data(), filtered.size())};
  }

 private:
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
  std::vector<std::uint8_t> filtered_;
  std::vector<std::uint8_t> compressed_;
  std::vector<std::uint8_t> level_memory_ = std::vector<std::uint8_t>(level_memory);
  isal_zstream stream_{};  // igzip's initialisation leaves some fields unset that it reads
};

bool is_static(const StaticPart& background, int first_row) {
  return std::ranges::none_of(background.damage, [&](const Area& area) {
    return area.y < first_row + band_height && area.y + area.height > first_row;
  });
}

}  // namespace

const CompressedBand& StaticBands::get(int first_row,
                                       const std::function<CompressedBand()>& compress) {
  Entry* entry = nullptr;
  {
    const std::lock_guard lock(mutex_);
    entry = &entries_[first_row];
  }
  std::call_once(entry->once, [&] { entry->band = compress(); });
  return entry->band;
}

std::vector<std::uint8_t> compress_rows(const Image& image, const StaticPart* background) {
  BandCompressor compress(image);
  std::vector<std::uint8_t> stream(header.begin(), header.end());
  std::uint32_t checksum = 1;
  const auto add = [&](std::span<const std::uint8_t> bytes, std::uint32_t band_checksum, int rows) {
    stream.insert(stream.end(), bytes.begin(), bytes.end());
    checksum = static_cast<std::uint32_t>(
        adler32_combine(checksum, band_checksum, static_cast<z_off_t>(compress.size_of(rows))));
  };
  for (int first_row = 0; first_row < image.height; first_row += band_height) {
    const int rows = std::min(band_height, image.height - first_row);
    if (background != nullptr && is_static(*background, first_row)) {
      const CompressedBand& kept = background->bands.get(first_row, [&] {
        const auto [bytes, band_checksum] = compress(first_row, rows);
        return CompressedBand{{bytes.begin(), bytes.end()}, band_checksum};
      });
      add(kept.bytes, kept.checksum, rows);
    } else {
      const auto [bytes, band_checksum] = compress(first_row, rows);
      add(bytes, band_checksum, rows);
    }
  }
  stream.insert(stream.end(), last_block.begin(), last_block.end());
  for (const int shift : {24, 16, 8, 0}) {
    stream.push_back(static_cast<std::uint8_t>(checksum >> shift));
  }
  return stream;
}

}  // namespace twrench::image
