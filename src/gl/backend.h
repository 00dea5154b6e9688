#pragma once

#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gl/context.h"

namespace twrench::gl {

enum class Backend { automatic, osmesa, egl };

/// What is wanted of OpenGL.
struct BackendChoice {
  Backend backend = Backend::automatic;
  std::optional<std::string> egl_device;  ///< as make_egl_context takes it; EGL is then wanted
};

struct OpenedContext {
  std::unique_ptr<Context> context;
  std::string note;  ///< what it fell back to, and why; empty when it is what was wanted
};

/// A context of the back end that is wanted.
///
/// `automatic` is the first hardware device of EGL that answers, else OSMesa, else EGL's software;
/// `egl` without a device is the same without OSMesa. Either says in the note when it is no
/// hardware. A device or OSMesa asked for by name is that or an error.
///
/// Throws GlError, with the remedy, when there is none, and UsageError as make_egl_context and
/// where a device of EGL is asked for with OSMesa.
OpenedContext open_context(const BackendChoice& choice);

/// A way to OpenGL, and whether it can be used here.
struct BackendReport {
  std::string name;            ///< as the options say it: "osmesa", "egl 0", "egl surfaceless"
  std::string renderer;        ///< what GL calls itself; empty when it cannot be used
  std::exception_ptr failure;  ///< the Error then
};

/// Tries every back end and device there is, one after the other. Throws nothing of its own.
std::vector<BackendReport> backends();

}  // namespace twrench::gl
