#include "gl/readback.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "gl/error.h"

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

}  // namespace twrench::gl
