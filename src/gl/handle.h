#pragma once

#include <utility>

#include "gl/functions.h"

namespace twrench::gl {

/// Owns the name of a GL object, generated on construction and deleted on destruction. Move-only.
/// The function table and its context must outlive it.
template <auto Generate, auto Delete>
class Handle {
 public:
  explicit Handle(const Functions& gl) : gl_(&gl) { (gl.*Generate)(1, &id_); }
  ~Handle() {
    if (id_ != 0) (gl_->*Delete)(1, &id_);
  }
  Handle(Handle&& other) noexcept : gl_(other.gl_), id_(std::exchange(other.id_, 0)) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;

  GLuint id() const { return id_; }

 private:
  const Functions* gl_;
  GLuint id_ = 0;
};

using Buffer = Handle<&Functions::GenBuffers, &Functions::DeleteBuffers>;
using VertexArray = Handle<&Functions::GenVertexArrays, &Functions::DeleteVertexArrays>;
using Renderbuffer = Handle<&Functions::GenRenderbuffers, &Functions::DeleteRenderbuffers>;
using FramebufferObject = Handle<&Functions::GenFramebuffers, &Functions::DeleteFramebuffers>;

}  // namespace twrench::gl
