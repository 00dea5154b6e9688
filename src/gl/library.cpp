#include "gl/library.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace twrench::gl {

Library::Library(std::span<const char* const> names, const std::string& remedy,
                 GlError::Reason reason) {
  for (const char* name : names) {
    handle_ = dlopen(name, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    if (handle_ != nullptr) return;
  }
  throw GlError("OpenGL", fmt::format("none of {} could be loaded", fmt::join(names, ", ")), remedy,
                reason);
}

void* Library::symbol(const char* name) const { return dlsym(handle_, name); }

}  // namespace twrench::gl
