#pragma once

#include <optional>
#include <span>
#include <vector>

#include "draw/body_pass.h"
#include "draw/draw_list_pass.h"
#include "draw/floor.h"
#include "draw/view_painter.h"
#include "gl/framebuffer.h"
#include "picture/space/screen_area.h"
#include "picture/views/body_view.h"

namespace twrench::draw {

/// The painter of a view of the body.
class BodyPainter final : public ViewPainter {
 public:
  /// The framebuffer has the size of the picture. It and the view must outlive the painter. `parts`
  /// are the visible parts of the body, which cast a shadow on the floor. Edges are antialiased
  /// analytically unless `is_multisampled`.
  BodyPainter(const gl::Functions& gl, const gl::Framebuffer& framebuffer,
              const picture::BodyView& view, std::span<const body::Part> parts,
              bool is_multisampled);

  std::vector<picture::Layer> draw_still(const picture::ViewContents& contents) override;
  std::vector<PendingLayer> draw(const picture::ViewContents& contents) override;

 private:
  picture::ScreenArea covered(const picture::ViewContents& contents,
                              std::span<const Eigen::Matrix3d> poses) const;
  std::vector<gl::Rectangle> rectangles_of(std::span<const image::Area> areas) const;
  std::vector<gl::Readback> draw_areas(const picture::ViewContents& contents,
                                       const Eigen::Matrix3d& X,
                                       std::span<const image::Area> areas);
  void draw_sharp(const picture::ViewContents& contents, std::vector<PendingLayer>& layers);
  void draw_blurred(const picture::ViewContents& contents, std::vector<PendingLayer>& layers);

  const gl::Framebuffer& framebuffer_;
  const picture::BodyView& view_;
  int band_height_;  ///< Rows of the picture that are cleared and read back together.
  BodyPass body_;
  DrawListPass draw_list_pass_;
  DrawListPainter still_painter_;
  bool is_multisampled_;
  std::optional<Floor> floor_;
};

}  // namespace twrench::draw
