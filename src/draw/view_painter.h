#pragma once

#include <vector>

#include "draw/pending_layer.h"
#include "picture/views/view.h"

namespace twrench::draw {

/// Draws what a view shows, on its renderer's thread.
class ViewPainter {
 public:
  virtual ~ViewPainter() = default;

  /// Returns what View::add_still() has put into the contents, as layers in the order in which they
  /// are composited.
  virtual std::vector<picture::Layer> draw_still(const picture::ViewContents& contents) = 0;

  /// Returns the contents as layers in the order in which they are composited. They lie entirely
  /// inside the picture and are as small as what they show. This painter and others may draw on
  /// before a layer is completed; the painter outlives its layers.
  virtual std::vector<PendingLayer> draw(const picture::ViewContents& contents) = 0;
};

}  // namespace twrench::draw
