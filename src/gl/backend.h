#pragma once

#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gl/context.h"

namespace twrench::gl {

enum class Backend { automatic, osmesa, egl };

/// Returns the names of the backends: auto, osmesa and egl.
std::vector<std::string> backend_names();

/// Returns the backend of that name. Throws InvalidArgument about "backend" for others.
Backend backend_named(const std::string& name);

/// The requested OpenGL backend.
struct BackendChoice {
  /// The backend.
  Backend backend = Backend::automatic;
  /// The device name for make_egl_context(), which then implies EGL.
  std::optional<std::string> egl_device;
};

class ChildCall;

/// A trial of a backend in a child process, so that a crash of the driver does not end this
/// process. It runs in parallel with this process. Once a driver has worked in this process, no
/// further trials take place.
class BackendTrial {
 public:
  /// Starts the trial. Throws GlError in a process that was forked from one that has used OpenGL.
  explicit BackendTrial(BackendChoice choice);
  ~BackendTrial();

  /// Waits for the end of the trial and returns the choice. Throws GlError with a remedy if the
  /// driver crashes.
  const BackendChoice& finish();

 private:
  BackendChoice choice_;
  std::unique_ptr<ChildCall> call_;
  bool is_finished_ = false;
};

struct OpenedContext {
  /// The context, current on this thread.
  std::unique_ptr<Context> context;
  /// The backend used instead, and the reason; empty if the requested backend is used.
  std::string note;
};

/// Opens a context of the requested backend.
///
/// `automatic` selects the first available EGL hardware device, else OSMesa, else EGL in software;
/// `egl` without a device does the same without OSMesa. If the result is not hardware, the note
/// states this. A named device, or OSMesa by name, is never replaced: if it is not usable, an error
/// is thrown.
///
/// Throws GlError with a remedy if there is none, or the trial fails, and InvalidArgument as
/// make_egl_context() does, or if an EGL device is requested together with OSMesa.
OpenedContext open_context(BackendTrial& trial);
OpenedContext open_context(BackendChoice choice);

/// A backend or device, and whether it is usable here.
struct BackendReport {
  std::string name;      ///< in the syntax of the options: "osmesa", "egl 0", "egl surfaceless"
  std::string renderer;  ///< GL's renderer string; empty if it is not usable.
  std::exception_ptr failure;  ///< the Error if it is not usable
};

/// Tries every backend and device in sequence, each in a child process unless this one has used
/// OpenGL. Does not throw.
std::vector<BackendReport> backends();

}  // namespace twrench::gl
