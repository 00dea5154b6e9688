#pragma once

#include <cstddef>
#include <string>

#include "comparison/comparison.h"

namespace twrench::app {

/// A frame as the page of `twrench compare --report` shows it.
struct Article {
  /// An element of HTML with the pictures in it.
  std::string html;
  /// Size of the PNG files in it, in bytes.
  std::size_t picture_bytes;
};

/// Returns what is to be seen of a frame: the expected image, the actual one and their difference,
/// as far as there are any. Reads the files again: a film would not fit in memory. Throws
/// FileError.
Article compare_article(const comparison::FrameResult& frame,
                        const comparison::Comparison& comparison);

/// Returns the row of a table that tells of a frame without pictures.
std::string compare_table_row(const comparison::FrameResult& frame,
                              const comparison::Criteria& criteria);

}  // namespace twrench::app
