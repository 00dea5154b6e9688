#pragma once

#include <cstdint>

namespace twrench {

/// The arithmetic of Yuv420, row by row, which see. Ranges that are written overlap no others.
struct YuvRows {
  /// Y' of `count` pixels.
  void (*luma)(const std::uint8_t* rgb, std::uint8_t* out, int count);

  /// What each of `count` columns of two rows weighs in Cb and Cr: sums, not rounded yet.
  void (*columns)(const std::uint8_t* upper, const std::uint8_t* lower, int* blue, int* red,
                  int count);

  /// Cb or Cr: sample i from columns 2i to 2i + 2, of which the middle one counts twice.
  void (*chroma)(const int* columns, std::uint8_t* out, int count);
};

/// With instructions that every processor has.
YuvRows common_yuv_rows();

/// The same numbers, with the widest instructions that this processor has.
YuvRows fastest_yuv_rows();

}  // namespace twrench
