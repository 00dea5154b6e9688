#pragma once

#include <vector>

#include "draw/pending_layer.h"
#include "picture/views/view.h"

namespace twrench::draw {

/// Draws the contents of a view, on its renderer's thread.
class ViewPainter {
 public:
  virtual ~ViewPainter() = default;

  /// Returns the contents that View::add_still() added, as layers in compositing order.
  virtual std::vector<picture::Layer> draw_still(const picture::ViewContents& contents) = 0;

  /// Returns the contents as layers in compositing order. They lie entirely inside the picture and
  /// are as small as their contents. Painters may draw more before a layer is completed; the
  /// painter outlives its layers.
  virtual std::vector<PendingLayer> draw(const picture::ViewContents& contents) = 0;
};

}  // namespace twrench::draw
