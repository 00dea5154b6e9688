#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <span>
#include <vector>

#include "image/area.h"
#include "image/image.h"

namespace twrench {

/// Some rows of a picture, compressed: a part of a zlib stream that refers to none before it.
struct CompressedBand {
  std::vector<std::uint8_t> bytes;
  std::uint32_t checksum = 1;  ///< Adler-32 of the rows
};

/// What bands of rows become that are the same in all frames of a film: each is compressed once.
/// Any number of threads at once.
class StillBands {
 public:
  /// The band that begins at that row; `compress` makes it when it is asked for the first time, and
  /// may throw.
  const CompressedBand& get(int first_row, const std::function<CompressedBand()>& compress);

 private:
  struct Entry {
    std::once_flag once;
    CompressedBand band;
  };
  std::mutex mutex_;              ///< of the map, in which entries stay where they are
  std::map<int, Entry> entries_;  ///< by the first row
};

/// Where a picture differs from what is the same in all frames of its film, and what that became.
struct StillPart {
  std::span<const Area> changed;
  StillBands& bands;
};

/// The zlib stream (RFC 1950) of a picture's filtered rows, made by ISA-L's igzip. It is always cut
/// into the same bands of rows, so that it is the same bytes with a `still` part and without
/// (null).
std::vector<std::uint8_t> compress_rows(const Image& image, const StillPart* still);

}  // namespace twrench
