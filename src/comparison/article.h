#pragma once

#include <cstddef>
#include <string>

#include "comparison/comparison.h"

namespace twrench::comparison {

/// A frame as the page of `twrench compare --report` shows it.
struct Article {
  /// An HTML element that contains the pictures.
  std::string html;
  /// Total size of its PNG files in bytes.
  std::size_t picture_bytes;
};

/// Returns the article on a frame, with the expected image, the actual one and their difference, as
/// far as they exist. Reads the files again, because a film would not fit in memory. Throws
/// FileError.
Article article_of(const FrameResult& frame, const Comparison& comparison);

/// Returns the table row of a frame that is listed without pictures.
std::string table_row(const FrameResult& frame, const Criteria& criteria);

}  // namespace twrench::comparison
