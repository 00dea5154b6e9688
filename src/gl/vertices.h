#pragma once

#include <cstddef>
#include <initializer_list>
#include <span>

#include "gl/functions.h"

namespace twrench::gl {

/// A vertex attribute that consists of floats.
struct Attribute {
  GLuint location;         ///< In the vertex shader.
  GLint size;              ///< Number of floats.
  std::size_t offset = 0;  ///< From the start of the vertex, in bytes.
};

/// Returns an offset in bytes as the pointer that GL expects.
inline const void* offset_pointer(std::size_t offset) {
  return reinterpret_cast<const void*>(offset);  // NOLINT(performance-no-int-to-ptr)
}

/// Makes the bound vertex array read these attributes from the bound array buffer, whose vertices
/// are `stride` bytes apart.
void set_attributes(const Functions& gl, std::size_t stride,
                    std::initializer_list<Attribute> attributes);

/// Replaces the contents of the buffer that is bound to `target`.
void upload(const Functions& gl, GLenum target, std::span<const std::byte> bytes, GLenum usage);

/// The same with the elements of a contiguous container.
template <typename Values>
void upload(const Functions& gl, GLenum target, const Values& values, GLenum usage) {
  upload(gl, target, std::as_bytes(std::span(values)), usage);
}

}  // namespace twrench::gl
