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
  framebuffer_.draw_within(screen.rectangle(), screen.viewport());
  framebuffer_.clear();
  pass_.draw_solid(solid);
  pass_.draw_fins(solid);
  pass_.draw_sheer(sheer);
  return made_of(framebuffer_.begin_read(screen.rectangle()), screen.area().x, screen.area().y);
}

}  // namespace twrench
