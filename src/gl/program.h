#pragma once

#include <cstddef>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <initializer_list>
#include <span>
#include <string_view>
#include <utility>

#include "gl/functions.h"

namespace twrench::gl {

/// A vertex attribute that consists of floats.
struct Attribute {
  GLuint location;         ///< In the vertex shader.
  GLint size;              ///< Number of floats.
  std::size_t offset = 0;  ///< From the start of the vertex, in bytes.
};

/// Returns an offset in bytes as the pointer that GL expects.
inline const void* offset_pointer(std::size_t offset) {
  return reinterpret_cast<const void*>(offset);  // NOLINT(performance-no-int-to-ptr)
}

/// Makes the bound vertex array read these attributes from the bound array buffer, whose vertices
/// are `stride` bytes apart.
void set_attributes(const Functions& gl, std::size_t stride,
                    std::initializer_list<Attribute> attributes);

/// Replaces the contents of the buffer that is bound to `target`.
void upload(const Functions& gl, GLenum target, std::span<const std::byte> bytes, GLenum usage);

/// The same with the elements of a contiguous container.
template <typename Values>
void upload(const Functions& gl, GLenum target, const Values& values, GLenum usage) {
  upload(gl, target, std::as_bytes(std::span(values)), usage);
}

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

/// A GLSL file without a #version line, which Program adds once for all files of a shader.
struct ShaderFile {
  /// File name for error messages.
  std::string_view name;
  /// GLSL source.
  std::string_view text;
};

/// A linked GLSL 3.30 program. Move-only.
class Program {
 public:
  /// Compiles each shader from its files in sequence. Throws GlError with the compiler's messages
  /// as FILE:LINE if a shader does not compile or the two do not link.
  Program(const Functions& gl, std::span<const ShaderFile> vertex,
          std::span<const ShaderFile> fragment);
  ~Program();
  Program(Program&& other) noexcept;
  Program& operator=(Program&& other) noexcept;
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  GLuint id() const { return id_; }
  void use() const { gl_->UseProgram(id_); }

  /// Sets a uniform of the program, which must be in use. Throws std::logic_error if the program
  /// has no uniform of that name, which means that C++ and GLSL disagree.
  void set(const char* name, float value) const;
  void set(const char* name, const glm::vec3& value) const;
  void set(const char* name, const glm::mat3& value) const;
  void set(const char* name, const glm::mat4& value) const;
  void set(const char* name, std::span<const glm::vec4> values) const;

 private:
  GLint location(const char* name) const;

  const Functions* gl_;
  GLuint id_ = 0;
};

}  // namespace twrench::gl
