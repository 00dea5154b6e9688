#include "draw/draw_list_painter.h"

#include "draw/rectangle.h"
#include "picture/space/screen_area.h"

namespace twrench::draw {

std::vector<picture::Layer> DrawListPainter::draw_still(const picture::ViewContents& contents) {
  std::vector<picture::Layer> layers;
  for (PendingLayer& layer : draw(contents)) {
    layer.fetch();
    layers.push_back(std::get<picture::Layer>(layer.finish()));
  }
  return layers;
}

std::vector<PendingLayer> DrawListPainter::draw(const picture::ViewContents& contents) {
  if (contents.is_empty()) return {};
  picture::ScreenArea screen(pane_);
  contents.opaque.add_to(screen);
  contents.translucent.add_to(screen);
  const image::Area area = screen.bounds();
  const gl::Rectangle rectangle = gl_rectangle(area, framebuffer_.height());
  framebuffer_.clear({&rectangle, 1});
  framebuffer_.draw_within(rectangle, gl_rectangle(pane_, framebuffer_.height()));
  pass_.draw_opaque(contents.opaque);
  pass_.draw_edge_quads(contents.opaque);
  pass_.draw_translucent(contents.translucent);
  std::vector<PendingLayer> layers;
  layers.push_back(layer_at(area, framebuffer_.begin_read(rectangle)));
  return layers;
}

}  // namespace twrench::draw
