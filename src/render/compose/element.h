#pragma once

#include <optional>
#include <vector>

#include "render/compose/label.h"
#include "render/compose/pending_layer.h"
#include "timeline/timeline.h"

namespace twrench::render {

/// An element of the picture that is drawn without OpenGL, over the views: a plot, a legend, text.
class Element {
 public:
  virtual ~Element() = default;

  /// Returns its layers, in the order in which they are composited. They lie entirely inside the
  /// picture and are as small as their contents. Called on any thread, but not on two at once.
  virtual std::vector<Layer> draw(const timeline::FrameState& state) = 0;
};

/// A view of objects in space, drawn by OpenGL; to be used on its renderer's thread.
class SpaceView {
 public:
  virtual ~SpaceView() = default;

  /// Returns the static layers, which are the same in every frame through the same camera.
  virtual std::vector<Layer> static_layers() { return {}; }

  /// Returns the layers that change, in the order in which they are composited, like those of
  /// Element::draw(). The view and others may draw on before a layer is completed; the view
  /// outlives its layers.
  virtual std::vector<PendingLayer> draw(const timeline::FrameState& state) = 0;

  /// Returns the labels of its contents, which are drawn over all elements.
  virtual std::vector<Label> labels(const timeline::FrameState& state) const = 0;

  /// Returns the camera at `video_time` seconds of video, since it may move, for coordinates in its
  /// own frame.
  virtual Camera camera(double video_time) const = 0;

  /// Returns the camera for coordinates in space.
  Camera camera_in_space(const timeline::FrameState& state) const {
    return other_camera_ ? *other_camera_ : own_camera_in_space(state);
  }

  /// Lets the view be seen through another camera than its own, which is for coordinates in space,
  /// until this is called with nothing.
  void look_through(const std::optional<Camera>& camera) { other_camera_ = camera; }

 protected:
  /// Returns the camera that the view has been told to use instead of its own.
  const std::optional<Camera>& other_camera() const { return other_camera_; }

 private:
  virtual Camera own_camera_in_space(const timeline::FrameState& state) const {
    return camera(state.video_time);
  }

  std::optional<Camera> other_camera_;
};

}  // namespace twrench::render
