#pragma once

#include <twrench/base/error.h>

namespace twrench::system {

/// A file could not be read or written, or does not hold what it should.
struct FileError : Error {
  using Error::Error;
};

/// An output would take the place of what nobody said may be lost.
struct OverwriteError : Error {
  using Error::Error;
};

}  // namespace twrench::system
