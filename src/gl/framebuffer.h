#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "gl/program.h"
#include "image/image.h"

namespace twrench::gl {

/// A rectangle of a framebuffer's pixels, from the bottom left corner as GL counts.
struct Rectangle {
  int x = 0, y = 0, width = 0, height = 0;
};

/// How pixels are read back.
enum class ReadMode {
  at_once,   ///< Directly into memory, after all drawing has finished.
  buffered,  ///< Into a pixel buffer while drawing continues.
};

/// Returns `buffered` for a graphics card. A software rasteriser runs on the same CPU, where a
/// buffer would only add a copy.
ReadMode best_read_mode(const Functions& gl);

/// A pool of pixel buffers, so that frames do not allocate them.
class PixelBuffers {
 public:
  struct Sized {
    /// The GL buffer.
    Buffer buffer;
    /// Size in bytes.
    GLsizeiptr size = 0;
  };

  explicit PixelBuffers(const Functions& gl) : gl_(&gl) {}

  /// Returns a buffer of at least `size` bytes, bound to GL_PIXEL_PACK_BUFFER. Throws GlError if
  /// there is no memory for it.
  Sized get(GLsizeiptr size);
  void give_back(Sized buffer) { free_.push_back(std::move(buffer)); }

 private:
  const Functions* gl_;
  std::vector<Sized> free_;
};

/// Pixels in transfer from a framebuffer to memory. The framebuffer's buffers and the context must
/// outlive it.
class Readback {
 public:
  /// Begins to read `area` of the framebuffer bound for reading, through one of `buffers`, or at
  /// once if that is null. Later drawing does not affect the result.
  Readback(const Functions& gl, const Rectangle& area, PixelBuffers* buffers);

  /// Returns whether fetch() would return without waiting.
  bool is_ready() const { return !buffer_; }

  /// Waits for the pixels, on the context's thread. Throws GlError if they were lost.
  void fetch();

  /// Returns the pixels as RGBA from the top left. Call it once: on any thread after fetch(), or
  /// else on the context's thread, because it then calls fetch(). Throws as fetch() does.
  image::Image finish();

 private:
  const Functions* gl_;
  int width_, height_;
  image::Image image_;  ///< From the bottom left; empty while the pixels are in the buffer.
  PixelBuffers* buffers_;
  std::optional<PixelBuffers::Sized> buffer_;
};

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
