#pragma once

#include <memory>
#include <string>

namespace twrench::gl {

/// An off-screen OpenGL core profile context, 3.3 or newer, current on the thread that made it.
class Context {
 public:
  virtual ~Context() = default;
  Context() = default;
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  /// The address of a GL function, or null.
  virtual void* function(const char* name) const = 0;
  /// "osmesa", "egl".
  virtual std::string backend() const = 0;
};

/// A context on the OSMesa library, loaded at run time. Throws GlError, with the remedy, when the
/// library is missing or has no core profile.
std::unique_ptr<Context> make_osmesa_context();

}  // namespace twrench::gl
