#pragma once

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <string_view>

#include "gl/functions.h"

namespace twrench::gl {

/// A file of GLSL, without a #version line: Program sets one for all files of a shader.
struct ShaderFile {
  std::string_view name;
  std::string_view text;
};

/// A linked GLSL 3.30 program, owned. Move-only.
class Program {
 public:
  /// Each shader is its files, one after the other. Throws GlError, with the compiler's messages
  /// as FILE:LINE, when a shader does not compile or the two do not link.
  Program(const Functions& gl, std::span<const ShaderFile> vertex,
          std::span<const ShaderFile> fragment);
  ~Program();
  Program(Program&& other) noexcept;
  Program& operator=(Program&& other) noexcept;
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  GLuint id() const { return id_; }
  void use() const { gl_->UseProgram(id_); }

  /// Sets a uniform of the program, which must be in use. Throws std::logic_error when the program
  /// has no uniform of that name: C++ and GLSL have come apart.
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
