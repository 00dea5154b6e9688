#pragma once

#include <optional>

#include "gl/handle.h"
#include "gl/program.h"
#include "image/image.h"

namespace twrench::gl {

/// Pixels of a framebuffer, from its bottom left corner as GL counts.
struct Rectangle {
  int x = 0, y = 0, width = 0, height = 0;
};

/// A colour (RGBA8) and depth (24 bits) framebuffer, multisampled or not.
class Framebuffer {
 public:
  /// Throws UsageError, with the remedy, for a size or a number of samples that this GL cannot
  /// do; GlError when it can but has not the memory.
  Framebuffer(const Functions& gl, int width, int height, int samples);

  int width() const { return width_; }
  int height() const { return height_; }

  /// What is drawn from now on lands here, within `area`; device coordinates span `viewport`.
  void draw_within(const Rectangle& area, const Rectangle& viewport) const;

  /// Makes the area that is drawn within transparent black, and as far as can be. Not by
  /// glClear: within a scissor Mesa draws a quad too, whose colour llvmpipe fetches for each pixel.
  void clear() const;

  /// The pixels of `area`, samples averaged, as RGBA from the top left. The area's size is at
  /// least 1 x 1 and it lies inside.
  Image read(const Rectangle& area) const;

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
};

}  // namespace twrench::gl
