#include "render/overlay/draw_list_layer.h"

#include <algorithm>

namespace twrench::render {

void DrawListLayer::begin(const Camera& camera) {
  opaque.begin(camera, area_);
  translucent.begin(camera, area_);
}

double DrawListLayer::hairline() const {
  return std::max(1.0, 0.0022 * std::min(area_.width, area_.height));
}

PendingLayer DrawListLayer::layer() const {
  ScreenArea screen(area_, framebuffer_.height());
  opaque.add_to(screen);
  translucent.add_to(screen);
  const image::Area area = screen.bounds();
  const gl::Rectangle rectangle = screen.rectangle(area);
  framebuffer_.clear({&rectangle, 1});
  framebuffer_.draw_within(rectangle, screen.viewport());
  pass_.draw_opaque(opaque);
  pass_.draw_edge_quads(opaque);
  pass_.draw_translucent(translucent);
  return made_of(framebuffer_.begin_read(rectangle), area.x, area.y);
}

}  // namespace twrench::render
