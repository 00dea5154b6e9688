#include "gl/functions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "gl/error.h"

namespace twrench::gl {
namespace {

struct Loader {
  const Context& context;

  template <typename F>
  void operator()(F& function, const char* name) const {
    function = reinterpret_cast<F>(context.function(name));
    if (function == nullptr) {
      throw GlError("OpenGL", fmt::format("the {} context has no {}", context.backend(), name));
    }
  }
};

std::string text(const Functions& gl, GLenum name) {
  const GLubyte* const value = gl.GetString(name);
  return value == nullptr ? std::string() : reinterpret_cast<const char*>(value);
}

}  // namespace

Functions::Functions(const Context& context) {
  const Loader load{context};
  load(GetError, "glGetError");
  load(GetIntegerv, "glGetIntegerv");
  load(GetString, "glGetString");
  load(GenBuffers, "glGenBuffers");
  load(DeleteBuffers, "glDeleteBuffers");
  load(BindBuffer, "glBindBuffer");
  load(BufferData, "glBufferData");
  load(MapBufferRange, "glMapBufferRange");
  load(UnmapBuffer, "glUnmapBuffer");
  load(GenVertexArrays, "glGenVertexArrays");
  load(DeleteVertexArrays, "glDeleteVertexArrays");
  load(BindVertexArray, "glBindVertexArray");
  load(EnableVertexAttribArray, "glEnableVertexAttribArray");
  load(VertexAttribPointer, "glVertexAttribPointer");
  load(CreateShader, "glCreateShader");
  load(DeleteShader, "glDeleteShader");
  load(ShaderSource, "glShaderSource");
  load(CompileShader, "glCompileShader");
  load(GetShaderiv, "glGetShaderiv");
  load(GetShaderInfoLog, "glGetShaderInfoLog");
  load(CreateProgram, "glCreateProgram");
  load(DeleteProgram, "glDeleteProgram");
  load(AttachShader, "glAttachShader");
  load(LinkProgram, "glLinkProgram");
  load(GetProgramiv, "glGetProgramiv");
  load(GetProgramInfoLog, "glGetProgramInfoLog");
  load(UseProgram, "glUseProgram");
  load(GetAttribLocation, "glGetAttribLocation");
  load(GetUniformLocation, "glGetUniformLocation");
  load(Uniform1f, "glUniform1f");
  load(Uniform3fv, "glUniform3fv");
  load(Uniform4fv, "glUniform4fv");
  load(UniformMatrix3fv, "glUniformMatrix3fv");
  load(UniformMatrix4fv, "glUniformMatrix4fv");
  load(GenRenderbuffers, "glGenRenderbuffers");
  load(DeleteRenderbuffers, "glDeleteRenderbuffers");
  load(BindRenderbuffer, "glBindRenderbuffer");
  load(RenderbufferStorageMultisample, "glRenderbufferStorageMultisample");
  load(GenFramebuffers, "glGenFramebuffers");
  load(DeleteFramebuffers, "glDeleteFramebuffers");
  load(BindFramebuffer, "glBindFramebuffer");
  load(FramebufferRenderbuffer, "glFramebufferRenderbuffer");
  load(CheckFramebufferStatus, "glCheckFramebufferStatus");
  load(BlitFramebuffer, "glBlitFramebuffer");
  load(ReadPixels, "glReadPixels");
  load(PixelStorei, "glPixelStorei");
  load(Flush, "glFlush");
  load(Viewport, "glViewport");
  load(Scissor, "glScissor");
  load(Enable, "glEnable");
  load(Disable, "glDisable");
  load(BlendFunc, "glBlendFunc");
  load(DepthFunc, "glDepthFunc");
  load(DepthMask, "glDepthMask");
  load(FrontFace, "glFrontFace");
  load(ClearColor, "glClearColor");
  load(Clear, "glClear");
  load(DrawArrays, "glDrawArrays");
  load(DrawElements, "glDrawElements");
}

std::string renderer_string(const Functions& gl) {
  return fmt::format("{}, OpenGL {}", text(gl, GL_RENDERER), text(gl, GL_VERSION));
}

bool draws_in_software(const Functions& gl) {
  constexpr std::array<std::string_view, 4> names{"llvmpipe", "softpipe", "swrast",
                                                  "Software Rasterizer"};
  const std::string renderer = text(gl, GL_RENDERER);
  return std::ranges::any_of(
      names, [&](std::string_view name) { return renderer.find(name) != std::string::npos; });
}

}  // namespace twrench::gl
