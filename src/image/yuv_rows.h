#pragma once

#include <cstdint>

namespace twrench::image {

/// The arithmetic of Yuv420 by rows. Output ranges must not overlap other ranges.
struct YuvRows {
  /// Converts `count` pixels to Y'.
  void (*luma)(const std::uint8_t* rgb, std::uint8_t* out, int count);

  /// Computes the weights of `count` columns of two rows in Cb and Cr, as sums that are not yet
  /// rounded.
  void (*columns)(const std::uint8_t* upper, const std::uint8_t* lower, int* blue, int* red,
                  int count);

  /// Computes Cb or Cr: sample i from columns 2i to 2i + 2, with double weight on the middle one.
  void (*chroma)(const int* columns, std::uint8_t* out, int count);
};

/// Returns the implementation for all processors.
YuvRows common_yuv_rows();

/// Returns the implementation with the widest instructions of this processor; its results are the
/// same.
YuvRows fastest_yuv_rows();

}  // namespace twrench::image
