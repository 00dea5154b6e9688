#include "gl/program.h"

#include <fmt/format.h>

#include <charconv>
#include <glm/gtc/type_ptr.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"

namespace twrench::gl {
namespace {

constexpr std::string_view version = "#version 330 core\n";

/// A shader object, deleted when its program is linked or given up.
struct Shader {
  const Functions& gl;
  GLuint id;

  Shader(const Functions& functions, GLenum stage) : gl(functions), id(gl.CreateShader(stage)) {}
  ~Shader() { gl.DeleteShader(id); }
  Shader(const Shader&) = delete;
  Shader& operator=(const Shader&) = delete;
};

/// Compilers name a file by the number that #line gave it: "1:7(3): error" (Mesa) or "1(7) :"
/// (others) for line 7 of the first file. The line with that number replaced by FILE:LINE.
std::string named_line(std::string_view line, std::span<const ShaderFile> files) {
  const char* const end = line.data() + line.size();
  std::size_t file = 0;
  int number = 0;
  const auto after_file = std::from_chars(line.data(), end, file);
  if (after_file.ec != std::errc() || file < 1 || file > files.size()) return std::string(line);
  if (after_file.ptr == end) return std::string(line);
  const auto after_line = std::from_chars(after_file.ptr + 1, end, number);
  if (after_line.ec != std::errc()) return std::string(line);
  const std::string_view rest(after_line.ptr, static_cast<std::size_t>(end - after_line.ptr));
  return fmt::format("{}:{}{}", files[file - 1].name, number, rest);
}

/// The compiler's log on one line of text, its messages separated by "; ".
std::string named_log(std::string_view log, std::span<const ShaderFile> files) {
  std::string result;
  while (!log.empty()) {
    const std::size_t length = log.find('\n');
    const std::string_view line = log.substr(0, length);
    log.remove_prefix(length == std::string_view::npos ? log.size() : length + 1);
    if (line.empty()) continue;
    if (!result.empty()) result += "; ";
    result += named_line(line, files);
  }
  return result;
}

void compile(const Shader& shader, std::span<const ShaderFile> files) {
  std::string text(version);
  for (std::size_t i = 0; i < files.size(); ++i) {
    text += fmt::format("#line 1 {}\n{}\n", i + 1, files[i].text);
  }
  const Functions& gl = shader.gl;
  const GLchar* const begin = text.c_str();
  gl.ShaderSource(shader.id, 1, &begin, nullptr);
  gl.CompileShader(shader.id);
  GLint compiled = GL_FALSE;
  gl.GetShaderiv(shader.id, GL_COMPILE_STATUS, &compiled);
  if (compiled == GL_TRUE) return;
  std::string log(4096, '\0');
  GLsizei length = 0;
  gl.GetShaderInfoLog(shader.id, static_cast<GLsizei>(log.size()), &length, log.data());
  log.resize(static_cast<std::size_t>(length));
  throw GlError(fmt::format("shader {}", files.back().name), named_log(log, files));
}

}  // namespace

Program::Program(const Functions& gl, std::span<const ShaderFile> vertex,
                 std::span<const ShaderFile> fragment)
    : gl_(&gl), id_(0) {
  const Shader vertex_shader(gl, GL_VERTEX_SHADER);
  const Shader fragment_shader(gl, GL_FRAGMENT_SHADER);
  compile(vertex_shader, vertex);
  compile(fragment_shader, fragment);
  id_ = gl.CreateProgram();
  gl.AttachShader(id_, vertex_shader.id);
  gl.AttachShader(id_, fragment_shader.id);
  gl.LinkProgram(id_);
  GLint linked = GL_FALSE;
  gl.GetProgramiv(id_, GL_LINK_STATUS, &linked);
  if (linked == GL_TRUE) return;
  std::string log(4096, '\0');
  GLsizei length = 0;
  gl.GetProgramInfoLog(id_, static_cast<GLsizei>(log.size()), &length, log.data());
  log.resize(static_cast<std::size_t>(length));
  gl.DeleteProgram(id_);
  throw GlError(fmt::format("shaders {} and {}", vertex.back().name, fragment.back().name),
                named_log(log, {}));
}

Program::~Program() {
  if (id_ != 0) gl_->DeleteProgram(id_);
}

Program::Program(Program&& other) noexcept : gl_(other.gl_), id_(std::exchange(other.id_, 0)) {}

Program& Program::operator=(Program&& other) noexcept {
  std::swap(gl_, other.gl_);
  std::swap(id_, other.id_);
  return *this;
}

GLint Program::location(const char* name) const {
  const GLint result = gl_->GetUniformLocation(id_, name);
  if (result < 0) throw std::logic_error(fmt::format("no uniform {} in the GLSL program", name));
  return result;
}

void Program::set(const char* name, float value) const { gl_->Uniform1f(location(name), value); }

void Program::set(const char* name, const glm::vec3& value) const {
  gl_->Uniform3fv(location(name), 1, glm::value_ptr(value));
}

void Program::set(const char* name, const glm::mat3& value) const {
  gl_->UniformMatrix3fv(location(name), 1, GL_FALSE, glm::value_ptr(value));
}

void Program::set(const char* name, const glm::mat4& value) const {
  gl_->UniformMatrix4fv(location(name), 1, GL_FALSE, glm::value_ptr(value));
}

void Program::set(const char* name, std::span<const glm::vec2> values) const {
  gl_->Uniform2fv(location(name), static_cast<GLsizei>(values.size()),
                  glm::value_ptr(values.front()));
}

void Program::set(const char* name, std::span<const glm::vec3> values) const {
  gl_->Uniform3fv(location(name), static_cast<GLsizei>(values.size()),
                  glm::value_ptr(values.front()));
}

}  // namespace twrench::gl
