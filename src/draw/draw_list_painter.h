#pragma once

#include "draw/draw_list_pass.h"
#include "draw/view_painter.h"
#include "gl/framebuffer.h"

namespace twrench::draw {

/// The painter of a view without a body.
class DrawListPainter final : public ViewPainter {
 public:
  /// The view fills `pane`. The framebuffer has the size of the picture and must outlive the
  /// painter.
  DrawListPainter(const gl::Functions& gl, const gl::Framebuffer& framebuffer,
                  const image::Area& pane)
      : framebuffer_(framebuffer), pass_(gl), pane_(pane) {}

  std::vector<picture::Layer> draw_still(const picture::ViewContents& contents) override;
  std::vector<PendingLayer> draw(const picture::ViewContents& contents) override;

 private:
  const gl::Framebuffer& framebuffer_;
  DrawListPass pass_;
  image::Area pane_;
};

}  // namespace twrench::draw
