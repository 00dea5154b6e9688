#pragma once

#include <twrench/base/error.h>

#include <memory>
#include <string>
#include <vector>

namespace twrench::gl {

/// An off-screen OpenGL core profile context, 3.3 or newer, current on the thread that created it.
class Context {
 public:
  virtual ~Context() = default;
  Context() = default;
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  /// Returns the address of a GL function, or null.
  virtual void* function(const char* name) const = 0;
  /// Returns "osmesa" or "egl".
  virtual std::string backend() const = 0;
};

/// Creates a context with the OSMesa library, which is loaded at run time. Throws GlError with a
/// remedy if the library is missing or has no core profile.
std::unique_ptr<Context> make_osmesa_context();

/// An EGL device.
struct EglDevice {
  /// Name for make_egl_context(): "0", "1", ... in EGL's order, or "surfaceless".
  std::string name;
  /// Whether it reports itself as a software rasteriser.
  bool software = false;
};

/// Returns the devices that EGL enumerates (EGL_EXT_device_enumeration), followed by Mesa's
/// surfaceless platform if present, which selects a device itself. Opens none of them. Throws
/// GlError with a remedy if the EGL library is missing or too old to enumerate.
std::vector<EglDevice> egl_devices();

/// Creates a surfaceless context with the EGL library, which is loaded at run time. `device` is the
/// name of one of egl_devices(), or "software" for the first software rasteriser. Throws
/// InvalidArgument for an unknown device, and GlError with the reason if it provides no context.
std::unique_ptr<Context> make_egl_context(const std::string& device);

/// OpenGL is not usable, or does not support the request.
class GlError : public Error {
 public:
  enum class Reason {
    failed,              ///< none of the reasons below
    no_osmesa,           ///< the OSMesa library is missing or lacks a required feature
    egl_device_refused,  ///< the EGL device provides no context
    crashed,             ///< the driver crashes or hangs
    forked,              ///< this process was forked from one that has used OpenGL
  };

  GlError(const std::string& what, const std::string& why, const std::string& remedy = {},
          Reason reason = Reason::failed)
      : Error(what, why, remedy), reason_(reason) {}

  Reason reason() const noexcept { return reason_; }

 private:
  Reason reason_;
};

}  // namespace twrench::gl
