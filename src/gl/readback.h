#pragma once

#include <optional>
#include <vector>

#include "gl/handle.h"
#include "image/image.h"

namespace twrench::gl {

/// Pixels of a framebuffer, from its bottom left corner as GL counts.
struct Rectangle {
  int x = 0, y = 0, width = 0, height = 0;
};

/// How pixels are read back.
enum class ReadMode {
  at_once,   ///< into memory, when all that was drawn before is there
  buffered,  ///< into a pixel buffer, while drawing goes on
};

/// `buffered` on a graphics card. A software rasteriser draws on the processor that would wait, and
/// a buffer would only be one copy more.
ReadMode best_read_mode(const Functions& gl);

/// Pixel buffers for reuse, so that none is made a frame.
class PixelBuffers {
 public:
  struct Sized {
    Buffer buffer;
    GLsizeiptr size = 0;  ///< bytes
  };

  explicit PixelBuffers(const Functions& gl) : gl_(&gl) {}

  /// One of at least `size` bytes, bound to GL_PIXEL_PACK_BUFFER. Throws GlError when there is no
  /// memory for it.
  Sized get(GLsizeiptr size);
  void give_back(Sized buffer) { free_.push_back(std::move(buffer)); }

 private:
  const Functions* gl_;
  std::vector<Sized> free_;
};

/// Pixels of a framebuffer on their way into memory. Those from whose framebuffer they come, and
/// the context, outlive it.
class Readback {
 public:
  /// Begins to read `area` of the framebuffer that is bound for reading, through one of `buffers`,
  /// or at once where that is null. What is drawn from now on is not in it.
  Readback(const Functions& gl, const Rectangle& area, PixelBuffers* buffers);

  /// Whether take() waits for nothing.
  bool is_there() const { return !buffer_; }

  /// The pixels as RGBA from the top left, waited for. To be called once. Throws GlError when they
  /// were lost on the way.
  Image take();

 private:
  const Functions* gl_;
  int width_, height_;
  Image image_;  ///< empty while it is in the buffer
  PixelBuffers* buffers_;
  std::optional<PixelBuffers::Sized> buffer_;
};

}  // namespace twrench::gl
