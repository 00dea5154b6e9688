#pragma once

#include <span>
#include <string>

#include "gl/error.h"

namespace twrench::gl {

/// Returns whether this process has opened a Library. Throws GlError if it was forked from a
/// process that has, because a driver's threads and locks do not survive a fork.
bool has_used_opengl();

/// A shared library, opened at run time and never closed, because GL drivers leave threads and
/// thread-local destructors behind that outlive every context.
class Library {
 public:
  /// Opens the first of `names` that the loader finds. If there is none, throws GlError with
  /// `remedy` and `reason`, and lists the names. Also throws as has_used_opengl() does.
  Library(std::span<const char* const> names, const std::string& remedy,
          GlError::Reason reason = GlError::Reason::failed);

  /// Returns the address of a symbol, or null.
  void* symbol(const char* name) const;

 private:
  void* handle_ = nullptr;
};

}  // namespace twrench::gl
