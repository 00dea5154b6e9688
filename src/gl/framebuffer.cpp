#include "gl/framebuffer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "gl/error.h"

namespace twrench::gl {
namespace {

GLint limit(const Functions& gl, GLenum name) {
  GLint value = 0;
  gl.GetIntegerv(name, &value);
  return value;
}

void check_limits(const Functions& gl, int width, int height, int samples) {
  std::array<GLint, 2> viewport{};
  gl.GetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport.data());
  const GLint side = limit(gl, GL_MAX_RENDERBUFFER_SIZE);
  const GLint max_width = std::min(side, viewport[0]);
  const GLint max_height = std::min(side, viewport[1]);
  if (width > max_width || height > max_height) {
    throw InvalidArgument(
        fmt::format("size {}x{}", width, height),
        fmt::format("this OpenGL implementation draws at most {}x{}", max_width, max_height),
        fmt::format("choose a size of at most {}x{}", max_width, max_height));
  }
  const GLint max_samples = limit(gl, GL_MAX_SAMPLES);
  if (samples > max_samples) {
    throw OutOfRange(
        fmt::format("samples {}", samples),
        fmt::format("this OpenGL implementation supports at most {} per pixel", max_samples),
        {double(samples), 0, double(max_samples)},
        fmt::format("choose {} samples or fewer", max_samples));
  }
}

void allocate(const Functions& gl, const Renderbuffer& buffer, int samples, GLenum format,
              int width, int height) {
  gl.BindRenderbuffer(GL_RENDERBUFFER, buffer.id());
  gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
}

void check_complete(const Functions& gl, int width, int height, int samples) {
  const GLenum status = gl.CheckFramebufferStatus(GL_FRAMEBUFFER);
  const GLenum error = gl.GetError();
  if (status == GL_FRAMEBUFFER_COMPLETE && error == GL_NO_ERROR) return;
  throw GlError(
      fmt::format("framebuffer of {}x{} with {} samples", width, height, samples),
      fmt::format("OpenGL could not create it (status {:#x}, error {:#x})", status, error),
      "choose a smaller size or fewer samples");
}

/// Draws one triangle that covers everything, at the same depth in device coordinates.
Program clear_program(const Functions& gl) {
  static constexpr std::array vertex{ShaderFile{"clear.vert",
                                                "uniform float depth; void main() { gl_Position = "
                                                "vec4(4 * (gl_VertexID % 2) - 1, "
                                                "4 * (gl_VertexID / 2) - 1, depth, 1); }"}};
  static constexpr std::array fragment{
      ShaderFile{"clear.frag", "out vec4 color; void main() { color = vec4(0); }"}};
  return {gl, vertex, fragment};
}

}  // namespace

Framebuffer::Framebuffer(const Functions& gl, int width, int height, int samples, ReadMode mode)
    : gl_(&gl),
      width_(width),
      height_(height),
      color_(gl),
      depth_(gl),
      drawn_(gl),
      clear_program_(gl::clear_program(gl)),
      no_vertices_(gl),
      buffers_(mode == ReadMode::buffered ? std::make_unique<PixelBuffers>(gl) : nullptr) {
  check_limits(gl, width, height, samples);
  const bool multisampled = samples > 1;
  const int stored_samples = multisampled ? samples : 0;  // GL uses 0 for no multisampling
  if (multisampled) {
    allocate(gl, resolved_color_.emplace(gl), 0, GL_RGBA8, width, height);
    gl.BindFramebuffer(GL_FRAMEBUFFER, resolved_.emplace(gl).id());
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                               resolved_color_->id());
    check_complete(gl, width, height, 1);
  }
  allocate(gl, color_, stored_samples, GL_RGBA8, width, height);
  allocate(gl, depth_, stored_samples, GL_DEPTH_COMPONENT24, width, height);
  gl.BindFramebuffer(GL_FRAMEBUFFER, drawn_.id());
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color_.id());
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.id());
  check_complete(gl, width, height, samples);
}

void Framebuffer::clear(std::span<const Rectangle> areas) const { fill(areas, 1); }

void Framebuffer::block(std::span<const Rectangle> areas) const { fill(areas, -1); }

void Framebuffer::fill(std::span<const Rectangle> areas, float depth) const {
  clear_program_.use();
  clear_program_.set("depth", depth);
  gl_->BindVertexArray(no_vertices_.id());
  gl_->Disable(GL_CULL_FACE);
  gl_->Enable(GL_DEPTH_TEST);
  gl_->DepthFunc(GL_ALWAYS);
  for (const Rectangle& area : areas) {
    draw_within(area, area);
    gl_->DrawArrays(GL_TRIANGLES, 0, 3);
  }
  gl_->DepthFunc(GL_LESS);
}

void Framebuffer::draw_within(const Rectangle& area, const Rectangle& viewport) const {
  gl_->BindFramebuffer(GL_FRAMEBUFFER, drawn_.id());
  gl_->Viewport(viewport.x, viewport.y, viewport.width, viewport.height);
  gl_->Enable(GL_SCISSOR_TEST);
  gl_->Scissor(area.x, area.y, area.width, area.height);
}

Readback Framebuffer::begin_read(const Rectangle& area) const {
  gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, drawn_.id());
  if (resolved_) {
    gl_->Scissor(area.x, area.y, area.width, area.height);  // restricts the blit too
    gl_->BindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_->id());
    const int right = area.x + area.width;
    const int top = area.y + area.height;
    gl_->BlitFramebuffer(area.x, area.y, right, top, area.x, area.y, right, top,
                         GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, resolved_->id());
  }
  return {*gl_, area, buffers_.get()};
}

}  // namespace twrench::gl
