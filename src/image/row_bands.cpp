#include "image/row_bands.h"

#include <isa-l/igzip_lib.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <memory>
#include <new>

namespace twrench {
namespace {

constexpr int level = 1;
constexpr std::size_t level_memory = ISAL_DEF_LVL1_DEFAULT;
constexpr int band_height =
    32;  // rows: half of it loses a percent of size, the double is less used

constexpr std::array<std::uint8_t, 2> header{0x78, 0x01};  // RFC 1950, 2.2: deflate, 32 kB, fastest
constexpr std::array<std::uint8_t, 2> last_block{0x03, 0x00};  // RFC 1951, 3.2.6: empty
constexpr std::size_t checksum_size = 4;

/// What does not compress is stored, in blocks of at most 65535 bytes with 5 before each (RFC 1951,
/// 3.2.4), and an empty one ends the band.
std::size_t most_compressed(std::size_t size) {
  return size + 5 * (size / 65535 + 2) + ISAL_DEF_MAX_HDR_SIZE;
}

/// Compresses bands, one after the other.
class Deflate {
 public:
  /// Writes the part of a stream that the rows become to `out`, which has room for the most that it
  /// can be, and returns its size.
  std::size_t operator()(std::span<const std::uint8_t> rows, std::uint8_t* out) {
    isal_deflate_stateless_init(&stream_);
    stream_.level = level;
    stream_.level_buf = memory_.get();
    stream_.level_buf_size = level_memory;
    stream_.flush = FULL_FLUSH;
    stream_.next_in = const_cast<std::uint8_t*>(rows.data());  // it is only read
    stream_.avail_in = static_cast<std::uint32_t>(rows.size());
    stream_.next_out = out;
    stream_.avail_out = static_cast<std::uint32_t>(most_compressed(rows.size()));
    if (isal_deflate_stateless(&stream_) != COMP_OK) throw std::bad_alloc();
    return stream_.total_out;
  }

 private:
  std::unique_ptr<std::uint8_t[]> memory_{new std::uint8_t[level_memory]};
  isal_zstream stream_{};  // its initialisation leaves some unset of what is read
};

std::uint32_t checksum_of(std::span<const std::uint8_t> rows) {
  return isal_adler32(1, rows.data(), rows.size());
}

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

stb::Bytes compress_rows(std::span<const std::uint8_t> rows, std::size_t row_bytes,
                         const StillPart* still) {
  const std::size_t band_bytes = band_height * row_bytes;
  const std::size_t bands = (rows.size() + band_bytes - 1) / band_bytes;
  stb::Bytes stream{stb::allocate(header.size() + bands * most_compressed(band_bytes) +
                                  last_block.size() + checksum_size)};
  Deflate deflate;
  std::uint8_t* out = std::ranges::copy(header, stream.data.get()).out;
  std::uint32_t checksum = 1;
  for (std::size_t i = 0; i < bands; ++i) {
    const auto band =
        rows.subspan(i * band_bytes, std::min(band_bytes, rows.size() - i * band_bytes));
    std::uint32_t band_checksum = 0;
    const int first_row = band_height * static_cast<int>(i);
    if (still != nullptr && is_still(*still, first_row)) {
      const CompressedBand& kept = still->bands.get(first_row, [&] {
        CompressedBand made{std::vector<std::uint8_t>(most_compressed(band.size())),
                            checksum_of(band)};
        made.bytes.resize(deflate(band, made.bytes.data()));
        made.bytes.shrink_to_fit();
        return made;
      });
      out = std::ranges::copy(kept.bytes, out).out;
      band_checksum = kept.checksum;
    } else {
      out += deflate(band, out);
      band_checksum = checksum_of(band);
    }
    checksum = static_cast<std::uint32_t>(
        adler32_combine(checksum, band_checksum, static_cast<z_off_t>(band.size())));
  }
  out = std::ranges::copy(last_block, out).out;
  for (unsigned shift = 32; shift > 0;)
    *out++ = static_cast<std::uint8_t>(checksum >> (shift -= 8));
  stream.size = static_cast<std::size_t>(out - stream.data.get());
  return stream;
}

}  // namespace twrench
