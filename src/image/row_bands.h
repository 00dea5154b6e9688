#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <span>
#include <vector>

#include "image/area.h"
#include "image/image.h"

namespace twrench::image {

/// A compressed band of an image's rows: a part of a zlib stream without references to earlier
/// data.
struct CompressedBand {
  /// The compressed data.
  std::vector<std::uint8_t> bytes;
  /// Adler-32 checksum of the rows.
  std::uint32_t checksum = 1;
};

/// The compressed bands of the static background, which are the same in all frames of a video; each
/// is compressed once. Thread-safe.
class StaticBands {
 public:
  /// Returns the band that begins at that row. On the first request, `compress` makes it, and may
  /// throw.
  const CompressedBand& get(int first_row, const std::function<CompressedBand()>& compress);

 private:
  struct Entry {
    std::once_flag once;
    CompressedBand band;
  };
  std::mutex mutex_;              ///< Guards the map, whose entries never move.
  std::map<int, Entry> entries_;  ///< By the first row.
};

/// The static background of a frame: where the image differs from it, and its compressed bands.
struct StaticPart {
  /// The damaged areas, relative to the static background.
  std::span<const Area> damage;
  /// The compressed static background.
  StaticBands& bands;
};

/// Returns the zlib stream (RFC 1950) of an image's filtered rows, compressed by ISA-L's igzip. The
/// rows are always cut into the same bands, so that the bytes are the same with and without
/// `background` (which may be null).
std::vector<std::uint8_t> compress_rows(const Image& image, const StaticPart* background);

}  // namespace twrench::image
