#include "gl/objects.h"

namespace twrench::gl {

void set_attributes(const Functions& gl, std::size_t stride,
                    std::initializer_list<Attribute> attributes) {
  for (const Attribute& attribute : attributes) {
    gl.EnableVertexAttribArray(attribute.location);
    gl.VertexAttribPointer(attribute.location, attribute.size, GL_FLOAT, GL_FALSE,
                           static_cast<GLsizei>(stride), offset_pointer(attribute.offset));
  }
}

void upload(const Functions& gl, GLenum target, std::span<const std::byte> bytes, GLenum usage) {
  gl.BufferData(target, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), usage);
}

}  // namespace twrench::gl
