#include "render/sketch_pad.h"

#include <algorithm>

namespace twrench {

void SketchPad::begin(const Camera& camera) {
  solid.begin(camera, area_);
  sheer.begin(camera, area_);
}

double SketchPad::hairline() const {
  return std::max(1.0, 0.0022 * std::min(area_.width, area_.height));
}

PendingLayer SketchPad::layer() const {
  ScreenArea screen(area_, framebuffer_.height());
  solid.add_to(screen);
  sheer.add_to(screen);
  const Area area = screen.bounds();
  const gl::Rectangle rectangle = screen.rectangle(area);
  framebuffer_.clear({&rectangle, 1});
  framebuffer_.draw_within(rectangle, screen.viewport());
  pass_.draw_solid(solid);
  pass_.draw_fins(solid);
  pass_.draw_sheer(sheer);
  return made_of(framebuffer_.begin_read(rectangle), area.x, area.y);
}

}  // namespace twrench
