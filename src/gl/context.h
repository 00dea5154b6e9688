#pragma once

#include <memory>
#include <string>
#include <vector>

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

/// A device on which EGL can draw.
struct EglDevice {
  std::string name;       ///< for make_egl_context: "0", "1", ... in EGL's order, or "surfaceless"
  bool software = false;  ///< it says that it is a software rasteriser
};

/// The devices that EGL lists (EGL_EXT_device_enumeration), and after them Mesa's surfaceless
/// platform, where there is one, which picks a device itself. Opens none of them. Throws GlError,
/// with the remedy, when the EGL library is missing or too old to tell.
std::vector<EglDevice> egl_devices();

/// A context without a surface on the EGL library, loaded at run time. `device` is the name of one
/// of egl_devices(), or "software" for the first that is a software rasteriser. Throws UsageError
/// for a device that there is not, GlError, with the reason, when there is no context on it.
std::unique_ptr<Context> make_egl_context(const std::string& device);

}  // namespace twrench::gl
