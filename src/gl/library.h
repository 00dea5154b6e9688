#pragma once

#include <span>
#include <string>

namespace twrench::gl {

/// A shared library, opened at run time and never closed, because GL drivers leave threads and
/// thread-local destructors behind that outlive every context.
class Library {
 public:
  /// Opens the first of `names` that the loader finds. Throws GlError with what was searched for
  /// and `remedy` if there is none.
  Library(std::span<const char* const> names, const std::string& remedy);

  /// Returns the address of a symbol, or null.
  void* symbol(const char* name) const;

 private:
  void* handle_ = nullptr;
};

}  // namespace twrench::gl
