#pragma once

#include <memory>
#include <optional>
#include <span>

#include "gl/objects.h"
#include "gl/program.h"
#include "gl/readback.h"

namespace twrench::gl {

/// A colour (RGBA8) and depth (24 bits) framebuffer with optional multisampling.
class Framebuffer {
 public:
  /// Throws InvalidArgument with a remedy for a size or sample count beyond this GL's limits, and
  /// GlError if it lacks the memory.
  Framebuffer(const Functions& gl, int width, int height, int samples, ReadMode mode);

  int width() const { return width_; }
  int height() const { return height_; }
  ReadMode read_mode() const { return buffers_ ? ReadMode::buffered : ReadMode::at_once; }

  /// Clears the areas to transparent black and the far depth. Does not use glClear: within a
  /// scissor Mesa draws a quad too, whose colour llvmpipe fetches for each pixel.
  void clear(std::span<const Rectangle> areas) const;

  /// Clears the areas to transparent black and the near depth, so that nothing is drawn there; a
  /// software rasteriser does not even shade it.
  void block(std::span<const Rectangle> areas) const;

  /// Directs drawing here, restricted to `area`; device coordinates span `viewport`.
  void draw_within(const Rectangle& area, const Rectangle& viewport) const;

  /// Begins to read the pixels of `area`, with samples averaged. The area must be at least 1 x 1
  /// and lie inside. Throws GlError if there is no memory for the pixels.
  Readback begin_read(const Rectangle& area) const;

 private:
  void fill(std::span<const Rectangle> areas, float depth) const;

  const Functions* gl_;
  int width_;
  int height_;
  Renderbuffer color_;
  Renderbuffer depth_;
  FramebufferObject drawn_;
  std::optional<Renderbuffer> resolved_color_;  // None without multisampling.
  std::optional<FramebufferObject> resolved_;
  Program clear_program_;
  VertexArray no_vertices_;
  std::unique_ptr<PixelBuffers> buffers_;  ///< None if pixels are read at once.
};

}  // namespace twrench::gl
