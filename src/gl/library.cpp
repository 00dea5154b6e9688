#include "gl/library.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <atomic>

namespace twrench::gl {
namespace {

/// The process that opened the first library, or 0. Global, because drivers are.
std::atomic<pid_t> user_of_opengl = 0;

}  // namespace

bool has_used_opengl() {
  const pid_t process = user_of_opengl;
  if (process == 0 || process == ::getpid()) return process != 0;
  throw GlError("OpenGL", "this process was forked from one that has used it",
                "fork before the first picture is drawn", GlError::Reason::forked);
}

Library::Library(std::span<const char* const> names, const std::string& remedy,
                 GlError::Reason reason) {
  if (!has_used_opengl()) user_of_opengl = ::getpid();
  for (const char* name : names) {
    handle_ = dlopen(name, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    if (handle_ != nullptr) return;
  }
  throw GlError("OpenGL", fmt::format("none of {} could be loaded", fmt::join(names, ", ")), remedy,
                reason);
}

void* Library::symbol(const char* name) const { return dlsym(handle_, name); }

}  // namespace twrench::gl
