#pragma once

#include <span>
#include <string>

#include "gl/error.h"

namespace twrench::gl {

/// Returns whether this process has opened a Library. Throws GlError if one from which it was
/// forked has: neither the threads of drivers nor their locks survive that.
bool has_used_opengl();

/// A shared library, opened at run time and never closed, because GL drivers leave threads and
/// thread-local destructors behind that outlive every context.
class Library {
 public:
  /// The first of `names` that the loader finds. Throws GlError, saying what was looked for and
  /// giving `remedy` and `reason`, when there is none; and as has_used_opengl() does.
  Library(std::span<const char* const> names, const std::string& remedy,
          GlError::Reason reason = GlError::Reason::failed);

  /// Returns the address of a symbol, or null.
  void* symbol(const char* name) const;

 private:
  void* handle_ = nullptr;
};

}  // namespace twrench::gl
