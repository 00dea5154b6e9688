#include "gl/framebuffer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "gl/context.h"

namespace twrench::gl {
namespace {

void read_pixels(const Functions& gl, const Rectangle& area, void* pixels) {
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl.ReadPixels(area.x, area.y, area.width, area.height, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
}

/// GL's rows run upwards, an Image's downwards.
void turn_upside_down(image::Image& image) {
  const auto row = static_cast<std::ptrdiff_t>(image.row_bytes());
  for (auto low = image.pixels.begin(), high = image.pixels.end() - row; low < high;
       low += row, high -= row) {
    std::swap_ranges(low, low + row, high);
  }
}

}  // namespace

ReadMode best_read_mode(const Functions& gl) {
  return draws_in_software(gl) ? ReadMode::at_once : ReadMode::buffered;
}

PixelBuffers::Sized PixelBuffers::get(GLsizeiptr size) {
  if (free_.empty()) free_.push_back({Buffer(*gl_)});
  Sized sized = std::move(free_.back());
  free_.pop_back();
  gl_->BindBuffer(GL_PIXEL_PACK_BUFFER, sized.buffer.id());
  if (sized.size < size) {
    gl_->BufferData(GL_PIXEL_PACK_BUFFER, size, nullptr, GL_STREAM_READ);
    if (const GLenum error = gl_->GetError(); error != GL_NO_ERROR) {
      gl_->BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
      throw GlError(fmt::format("pixel buffer of {} bytes", size),
                    fmt::format("OpenGL could not create it (error {:#x})", error),
                    "choose a smaller size");
    }
    sized.size = size;
  }
  return sized;
}

Readback::Readback(const Functions& gl, const Rectangle& area, PixelBuffers* buffers)
    : gl_(&gl), width_(area.width), height_(area.height), buffers_(buffers) {
  if (buffers == nullptr) {
    image_ = image::Image(width_, height_, 4);
    read_pixels(gl, area, image_.pixels.data());
    return;
  }
  buffer_.emplace(buffers->get(GLsizeiptr{4} * width_ * height_));
  read_pixels(gl, area, nullptr);
  gl.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  gl.Flush();  // otherwise the card might not start until we wait for it
}

void Readback::fetch() {
  if (!buffer_) return;
  image_ = image::Image(width_, height_, 4);
  gl_->BindBuffer(GL_PIXEL_PACK_BUFFER, buffer_->buffer.id());
  const void* const pixels = gl_->MapBufferRange(
      GL_PIXEL_PACK_BUFFER, 0, static_cast<GLsizeiptr>(image_.pixels.size()), GL_MAP_READ_BIT);
  if (pixels != nullptr) {
    std::copy_n(static_cast<const std::uint8_t*>(pixels), image_.pixels.size(),
                image_.pixels.begin());
  }
  const bool whole = pixels != nullptr && gl_->UnmapBuffer(GL_PIXEL_PACK_BUFFER) == GL_TRUE;
  gl_->BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  if (!whole) throw GlError("reading back", "the OpenGL buffer was lost");
  buffers_->give_back(std::move(*buffer_));
  buffer_.reset();
}

image::Image Readback::finish() {
  fetch();
  turn_upside_down(image_);
  return std::move(image_);
}

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
