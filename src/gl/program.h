#pragma once

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <string_view>

#include "gl/functions.h"

namespace twrench::gl {

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
