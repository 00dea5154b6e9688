#pragma once

#include <memory>
#include <optional>
#include <span>

#include "gl/handle.h"
#include "gl/program.h"
#include "gl/readback.h"

namespace twrench::gl {

/// A colour (RGBA8) and depth (24 bits) framebuffer, multisampled or not.
class Framebuffer {
 public:
  /// Throws UsageError, with the remedy, for a size or a number of samples that this GL cannot
  /// do; GlError when it can but has not the memory.
  Framebuffer(const Functions& gl, int width, int height, int samples, ReadMode mode);

  int width() const { return width_; }
  int height() const { return height_; }
  ReadMode read_mode() const { return buffers_ ? ReadMode::buffered : ReadMode::at_once; }

  /// Makes the areas transparent black, and as far as can be. Not by glClear: within a scissor Mesa
  /// draws a quad too, whose colour llvmpipe fetches for each pixel.
  void clear(std::span<const Rectangle> areas) const;

  /// What is drawn from now on lands here, within `area`; device coordinates span `viewport`.
  void draw_within(const Rectangle& area, const Rectangle& viewport) const;

  /// Begins to read the pixels of `area`, samples averaged. The area's size is at least 1 x 1 and
  /// it lies inside. Throws GlError when there is no memory for them.
  Readback begin_read(const Rectangle& area) const;

 private:
  const Functions* gl_;
  int width_;
  int height_;
  Renderbuffer color_;
  Renderbuffer depth_;
  FramebufferObject drawn_;
  std::optional<Renderbuffer> resolved_color_;  // none without multisampling
  std::optional<FramebufferObject> resolved_;
  Program clear_program_;
  VertexArray no_vertices_;
  std::unique_ptr<PixelBuffers> buffers_;  ///< none where pixels are read at once
};

}  // namespace twrench::gl
