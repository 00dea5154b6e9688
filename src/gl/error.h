#pragma once

#include <twrench/base/error.h>

namespace twrench::gl {

/// There is no usable OpenGL, or it cannot do what was asked.
class GlError : public Error {
 public:
  enum class Reason {
    failed,              ///< none of those below
    no_osmesa,           ///< the OSMesa library is missing or lacks what is needed
    egl_device_refused,  ///< no context can be had on the device of EGL
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
