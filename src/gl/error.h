#pragma once

#include <twrench/base/error.h>

namespace twrench::gl {

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
