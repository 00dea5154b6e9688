#include "gl/functions.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <string_view>

namespace twrench::gl {
namespace {

/// The process that opened the first library, or 0. Global, because drivers are.
std::atomic<pid_t> user_of_opengl = 0;

}  // namespace

bool has_used_opengl() {
  const pid_t process = user_of_opengl;
  if (process == 0 || process == ::getpid()) return process != 0;
  throw GlError("OpenGL", "this process was forked from one that has used it",
                "fork before the first picture is drawn", GlError::Reason::forked);
}

Library::Library(std::span<const char* const> names, const std::string& remedy,
                 GlError::Reason reason) {
  if (!has_used_opengl()) user_of_opengl = ::getpid();
  for (const char* name : names) {
    handle_ = dlopen(name, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    if (handle_ != nullptr) return;
  }
  throw GlError("OpenGL", fmt::format("none of {} could be loaded", fmt::join(names, ", ")), remedy,
                reason);
}

void* Library::symbol(const char* name) const { return dlsym(handle_, name); }

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
