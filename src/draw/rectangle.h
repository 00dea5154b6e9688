#pragma once

#include "gl/readback.h"
#include "image/area.h"

namespace twrench::draw {

/// Returns an area in OpenGL's coordinates, which count rows from the bottom of a picture of that
/// height.
inline gl::Rectangle gl_rectangle(const image::Area& area, int picture_height) {
  return {area.x, picture_height - area.y - area.height, area.width, area.height};
}

}  // namespace twrench::draw
