#include "gl/program.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <glm/gtc/type_ptr.hpp>
#include <stdexcept>
#include <string>

#include "gl/context.h"

namespace twrench::gl {

void set_attributes(const Functions& gl, std::size_t stride,
                    std::initializer_list<Attribute> attributes) {
  for (const Attribute& attribute : attributes) {
    gl.EnableVertexAttribArray(attribute.location);
    gl.VertexAttribPointer(attribute.location, attribute.size, GL_FLOAT, GL_FALSE,
                           static_cast<GLsizei>(stride), offset_pointer(attribute.offset));
  }
}

void upload(const Functions& gl, GLenum target, std::span<const std::byte> bytes, GLenum usage) {
  gl.BufferData(target, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), usage);
}

namespace {

constexpr std::string_view version = "#version 330 core\n";

/// A shader object, deleted when its program is linked or construction fails.
struct Shader {
  const Functions& gl;
  GLuint id;

  Shader(const Functions& functions, GLenum stage) : gl(functions), id(gl.CreateShader(stage)) {}
  ~Shader() { gl.DeleteShader(id); }
  Shader(const Shader&) = delete;
  Shader& operator=(const Shader&) = delete;
};

/// Number of lines of the file in the compiled text, where another newline ends it.
int line_count(const ShaderFile& file) {
  return static_cast<int>(std::count(file.text.begin(), file.text.end(), '\n')) + 1;
}

/// Returns `line` with its first source position replaced by FILE:LINE. The compiler sees the files
/// as one text after the version line, and refers to positions in it as "0:7(3): error" (Mesa),
/// "0(7) : error" or "ERROR: 0:7: ..." (others). (#line could number the files, but Mesa loses the
/// number in most errors.)
std::string named_line(std::string_view line, std::span<const ShaderFile> files) {
  const std::string_view place =
      line.substr(std::min(line.find_first_of("0123456789"), line.size()));
  const char* const end = place.data() + place.size();
  int source = 0;
  int number = 0;
  const auto after_source = std::from_chars(place.data(), end, source);
  if (after_source.ec != std::errc() || after_source.ptr == end) return std::string(line);
  const auto after_number = std::from_chars(after_source.ptr + 1, end, number);
  if (after_number.ec != std::errc()) return std::string(line);
  number -= 1;  // The version line.
  for (const ShaderFile& file : files) {
    const int lines = line_count(file);
    if (number <= lines)
      return fmt::format("{}:{}{}", file.name, number, std::string_view(after_number.ptr, end));
    number -= lines;
  }
  return std::string(line);
}

/// The compiler's log on one line, with messages separated by "; ".
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
  for (const ShaderFile& file : files) text += fmt::format("{}\n", file.text);
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
    : gl_(&gl) {
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

void Program::set(const char* name, std::span<const glm::vec4> values) const {
  gl_->Uniform4fv(location(name), static_cast<GLsizei>(values.size()),
                  glm::value_ptr(values.front()));
}

}  // namespace twrench::gl
