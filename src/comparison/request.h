#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

#include "comparison/comparison.h"

namespace twrench::comparison {

/// A comparison of two files or two folders, with its outputs.
struct Request {
  /// Two files, or two folders of frames.
  std::filesystem::path expected, actual;
  Criteria criteria;
  /// The PNG file for the amplified difference of two files; or empty.
  std::string difference = {};
  /// The file for a page that shows what differs; or empty.
  std::string page = {};
  /// Whether the expected file or folder may be missing, because it will be updated.
  bool may_be_new = false;
  /// Whether the outputs may replace files of other kinds.
  bool overwrite = false;
};

/// Compares two files or folders, and writes the difference and the page. `progress` is as for
/// compare_folders(). Throws InvalidArgument if a file is compared with a folder, OverwriteError as
/// FileList does, and as compare_folders() and compare_pictures() do.
Comparison compare(const Request& request,
                   const std::function<void(int done, int total)>& progress);

/// Accepts the actual frames: copies those that are different, have another format or are extra
/// over the expected ones, each atomically, and returns their number. Frames that are alike or
/// missing remain unchanged. Copies nothing if a frame could not be read. Throws FileError, also if
/// another run writes to the folder.
std::size_t update_expected(const Comparison& comparison);

}  // namespace twrench::comparison
