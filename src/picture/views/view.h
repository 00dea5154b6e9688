#pragma once

#include <Eigen/Core>
#include <optional>
#include <utility>
#include <vector>

#include "picture/compose/label.h"
#include "picture/compose/layout.h"
#include "picture/overlay/draw_list.h"
#include "timeline/timeline.h"

namespace twrench::picture {

/// The contents of a view at one time, as values. Reuse them for the next frame to reuse their
/// memory.
struct ViewContents {
  /// For coordinates in space.
  Camera camera;
  /// Whether the camera is on its way from another one, so that nothing stands still in it.
  bool is_moving = false;
  /// Attitude of the body, space_from_body; nothing if the view shows no body.
  std::optional<Eigen::Matrix3d> X;
  /// Its attitudes while the shutter is open; empty without motion blur.
  std::vector<Eigen::Matrix3d> blur;
  /// Items that hide one another and the body, and those that are blended over both in order.
  DrawList opaque, translucent;
  /// Names, which are drawn over all views and panels.
  std::vector<Label> labels;

  /// Removes all contents. Items are then added as `camera_in_space` sees them, whose picture fills
  /// `pane` and which `moves` from another camera.
  void begin(const Camera& camera_in_space, const image::Area& pane, bool moves = false);

  bool is_empty() const {
    return !X && opaque.vertices().empty() && translucent.vertices().empty();
  }
};

/// The place from which a view is seen.
struct Viewpoint {
  /// Direction of the eye, in rad; see direction_of().
  double azimuth, elevation;
  /// Magnification relative to the view's own framing.
  double zoom = 1;
};

/// Returns a view's framing as seen from `from`.
Framing seen_from(Framing framing, const Viewpoint& from);

/// A view of objects in space. It computes its contents and draws nothing.
class View {
 public:
  explicit View(Layout::Pane pane) : pane_(std::move(pane)) {}
  virtual ~View() = default;

  const Layout::Pane& pane() const { return pane_; }

  /// Returns the camera at `video_time` seconds of video, for coordinates in the view's own frame.
  Camera camera(double video_time) const { return camera_from(viewpoint(video_time)); }

  /// Returns the same for coordinates in space.
  Camera camera_in_space(const timeline::FrameState& state) const {
    return in_space(camera(state.video_time), state);
  }

  virtual Viewpoint viewpoint(double video_time) const = 0;
  virtual Camera camera_from(const Viewpoint& from) const = 0;

  /// Converts a camera for coordinates in the view's own frame to one for coordinates in space.
  virtual Camera in_space(const Camera& camera, const timeline::FrameState& /*state*/) const {
    return camera;
  }

  /// Adds the items that are the same in every frame to `contents`, which must be empty.
  virtual void add_still(ViewContents& /*contents*/) const {}

  /// Adds the items that change from frame to frame, as the contents' camera sees them.
  virtual void add(const timeline::FrameState& state, ViewContents& contents) const = 0;

 private:
  Layout::Pane pane_;
};

}  // namespace twrench::picture
