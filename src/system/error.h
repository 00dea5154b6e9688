#pragma once

#include <twrench/base/error.h>

namespace twrench::system {

/// A file could not be read or written, or has invalid contents.
struct FileError : Error {
  using Error::Error;
};

/// The reader of standard output has ended, as `head` does after its lines.
struct ClosedPipe : FileError {
  using FileError::FileError;
};

/// An output would overwrite a file without permission.
struct OverwriteError : Error {
  using Error::Error;
};

/// The file of an output exists, and is not one that the command may replace without permission.
struct ExistingFileError : OverwriteError {
  using OverwriteError::OverwriteError;
};

}  // namespace twrench::system
