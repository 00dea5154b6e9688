#pragma once

#include <filesystem>
#include <limits>
#include <string>

#include "recording/conventions/convention.h"

namespace twrench::scene {

/// The file of a recorded motion that a scene file names, and how it is read.
struct RecordingFile {
  /// The file as it was given.
  std::string file;
  /// The path from which it is read.
  std::filesystem::path path;
  /// The rows that are shown, by their times in s since the first row.
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
  /// Whether the noise of the rows is removed.
  bool smooth = false;
  /// How it is read, as far as the scene file states it.
  recording::Convention convention = {};
  /// The recording_keys() that are given, with their values, as the text of a JSON object.
  std::string keys = {};
};

}  // namespace twrench::scene
