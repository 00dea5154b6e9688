#pragma once

#include <vector>

#include "picture/compose/layer.h"
#include "timeline/timeline.h"

namespace twrench::picture {

/// An element of the picture that is drawn without OpenGL, over the views: a plot, a legend, text.
class Element {
 public:
  virtual ~Element() = default;

  /// Returns its layers, in the order in which they are composited. They lie entirely inside the
  /// picture and are as small as their contents. Called on any thread, but not on two at once.
  virtual std::vector<Layer> draw(const timeline::FrameState& state) = 0;
};

}  // namespace twrench::picture
