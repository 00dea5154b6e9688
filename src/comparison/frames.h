#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "system/error.h"

namespace twrench::comparison {

/// Two folders whose frames are compared, or two files.
struct Inputs {
  std::filesystem::path expected, actual;
  /// Whether they are folders; the frames are then the files in them.
  bool folders = true;

  std::filesystem::path expected_frame(const std::string& name) const;
  std::filesystem::path actual_frame(const std::string& name) const;
};

/// A frame by its name, and which folders have it.
struct FrameName {
  std::string name;
  bool is_expected = true;
  bool is_actual = true;
};

/// Returns the frames of two folders, sorted by name. A frame is a file named *.png, also in
/// capital letters, that is not hidden; subfolders are ignored. A folder that does not exist has no
/// frames. Throws FileError if a folder cannot be read.
std::vector<FrameName> frames_of(const Inputs& folders);

}  // namespace twrench::comparison
