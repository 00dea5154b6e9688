#include "image/row_bands.h"

#include <isa-l/igzip_lib.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <new>

#include "image/stb.h"

namespace twrench {
namespace {

constexpr int level = 1;
constexpr std::size_t level_memory = ISAL_DEF_LVL1_DEFAULT;

/// Rows per band. Half as many make files a percent larger; twice as many are less often static.
constexpr int band_height = 32;

constexpr std::array<std::uint8_t, 2> header{0x78, 0x01};  // RFC 1950, 2.2: deflate, 32 kB, fastest
constexpr std::array<std::uint8_t, 2> last_block{0x03, 0x00};  // RFC 1951, 3.2.6: empty

/// The largest size of a compressed band: incompressible data is stored in blocks of at most 65535
/// bytes with 5 bytes of header each (RFC 1951, 3.2.4), followed by an empty block.
std::size_t most_compressed(std::size_t size) {
  return size + 5 * (size / 65535 + 2) + ISAL_DEF_MAX_HDR_SIZE;
}

/// Compresses the bands of a picture one by one. A band stays in the cache from the filter to the
/// checksum, which a whole picture would not.
class BandCompressor {
 public:
  explicit BandCompressor(const Image& image)
      : image_(image), compressed_(most_compressed(size_of(band_height))) {}

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
    Result result{};
    const std::size_t first = static_cast<std::size_t>(first_row) * image_.row_bytes();
    stb::filter_rows(
        &image_.pixels[first], image_.width, rows, image_.channels,
        [&](std::span<std::uint8_t> filtered) {
          result = {deflate(filtered), isal_adler32(1, filtered.data(), filtered.size())};
        });
    if (result.bytes.empty()) throw std::bad_alloc();
    return result;
  }

 private:
  /// Compresses a part of the stream; empty if igzip fails.
  std::span<const std::uint8_t> deflate(std::span<std::uint8_t> rows) {
    isal_deflate_stateless_init(&stream_);
    stream_.level = level;
    stream_.level_buf = level_memory_.data();
    stream_.level_buf_size = level_memory;
    stream_.flush = FULL_FLUSH;
    stream_.next_in = rows.data();
    stream_.avail_in = static_cast<std::uint32_t>(rows.size());
    stream_.next_out = compressed_.data();
    stream_.avail_out = static_cast<std::uint32_t>(most_compressed(rows.size()));
    const bool done = isal_deflate_stateless(&stream_) == COMP_OK;
    return {compressed_.data(), done ? stream_.total_out : 0};
  }

  const Image& image_;
  std::vector<std::uint8_t> compressed_;
  std::vector<std::uint8_t> level_memory_ = std::vector<std::uint8_t>(level_memory);
  isal_zstream stream_{};  // igzip's initialisation leaves some fields unset that it reads
};

bool is_still(const StillPart& still, int first_row) {
  return std::ranges::none_of(still.changed, [&](const Area& area) {
    return area.y < first_row + band_height && area.y + area.height > first_row;
  });
}

}  // namespace

const CompressedBand& StillBands::get(int first_row,
                                      const std::function<CompressedBand()>& compress) {
  Entry* entry = nullptr;
  {
    const std::lock_guard lock(mutex_);
    entry = &entries_[first_row];
  }
  std::call_once(entry->once, [&] { entry->band = compress(); });
  return entry->band;
}

std::vector<std::uint8_t> compress_rows(const Image& image, const StillPart* still) {
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
    if (still != nullptr && is_still(*still, first_row)) {
      const CompressedBand& kept = still->bands.get(first_row, [&] {
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

}  // namespace twrench
