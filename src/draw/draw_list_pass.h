#pragma once

#include <span>

#include "draw/view_painter.h"
#include "gl/framebuffer.h"
#include "gl/program.h"
#include "picture/overlay/draw_list.h"

namespace twrench::draw {

/// Renders draw lists to the bound framebuffer as premultiplied colour.
class DrawListPass {
 public:
  explicit DrawListPass(const gl::Functions& gl);

  /// Draws, faintly, the parts of opaque items that the body hides; items fade as they enter the
  /// body. Only the body may have been drawn before.
  void draw_ghosts(const picture::DrawList& list) const;

  /// Draws opaque items with depth test and depth writes, and their outlines. Draw their edge quads
  /// when all of them are done.
  void draw_opaque(const picture::DrawList& list) const;
  void draw_edge_quads(const picture::DrawList& list) const;

  /// Draws translucent items, such as lines and glass: opaque items hide them, and they blend in
  /// order.
  void draw_translucent(const picture::DrawList& list) const { draw(list, list.items().faces, {}); }

 private:
  enum class Faces { all, near, far };

  /// How triangles are drawn.
  struct Mode {
    Faces faces = Faces::all;
    bool writes_depth = false;
    /// Whether to draw the parts behind other things, instead of those in front.
    bool hidden = false;
    double opacity = 1;
    /// Added to z in clip space.
    double clip_z = 0;
  };

  void draw(const picture::DrawList& list, const std::vector<std::uint32_t>& indices,
            const Mode& mode) const {
    draw_each(list, indices, {&mode, 1});
  }
  /// Draws the same triangles in each mode, in order; they are uploaded once.
  void draw_each(const picture::DrawList& list, const std::vector<std::uint32_t>& indices,
                 std::span<const Mode> modes) const;

  const gl::Functions* gl_;
  gl::Program program_;
  gl::VertexArray array_;
  gl::Buffer vertices_;
  gl::Buffer indices_;
};

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
