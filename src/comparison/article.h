#pragma once

#include <cstddef>
#include <string>

#include "comparison/comparison.h"

namespace twrench::comparison {

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
Article article_of(const FrameResult& frame, const Comparison& comparison);

/// Returns the row of a table that tells of a frame without pictures.
std::string table_row(const FrameResult& frame, const Criteria& criteria);

}  // namespace twrench::comparison
