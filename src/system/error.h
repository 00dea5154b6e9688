#pragma once

#include <twrench/base/error.h>

namespace twrench::system {

/// A file could not be read or written, or has invalid contents.
struct FileError : Error {
  using Error::Error;
};

/// An output would overwrite a file without permission.
struct OverwriteError : Error {
  using Error::Error;
};

}  // namespace twrench::system
