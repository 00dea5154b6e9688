#pragma once

#include <vector>

#include "render/compose/label.h"
#include "render/compose/pending_layer.h"
#include "timeline/timeline.h"

namespace twrench::render {

/// An element of the picture: a view of the body, a panel, a text block.
class Element {
 public:
  virtual ~Element() = default;

  /// Returns the static layers, which are the same in every frame; called once.
  virtual std::vector<Layer> static_layers() { return {}; }

  /// Returns the layers that change, in the order in which they are composited. Layers lie entirely
  /// inside the picture and are as small as their contents. Other elements may draw before a layer
  /// is resolved; the element outlives its layers.
  virtual std::vector<PendingLayer> draw(const timeline::FrameState& state) = 0;

  /// Returns the labels of its contents, which are drawn over all elements.
  virtual std::vector<Label> labels(const timeline::FrameState& /*state*/) const { return {}; }
};

/// An element that shows objects in space.
class SpaceView : public Element {
 public:
  /// Returns the camera at `video_time` seconds of video, since it may move, for coordinates in its
  /// own frame.
  virtual Camera camera(double video_time) const = 0;

  /// Returns the camera for coordinates in space.
  virtual Camera camera_in_space(const timeline::FrameState& state) const {
    return camera(state.video_time);
  }
};

}  // namespace twrench::render
