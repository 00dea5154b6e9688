#pragma once

#include "picture/look/theme.h"
#include "picture/views/principal_frame.h"
#include "picture/views/view.h"

namespace twrench::picture {

/// Base of the views that show a motion in its body's principal axes.
class SolutionView : public View {
 public:
  Viewpoint viewpoint(double video_time) const override;
  Camera camera_from(const Viewpoint& from) const override;

  /// Frames the contents for this direction of the camera at the start.
  void set_home(double azimuth, double elevation);

 protected:
  /// Shows solutions[solution] in `pane`.
  SolutionView(const scene::Scene& scene, const std::vector<timeline::Solution>& solutions,
               std::size_t solution, const Layout::Pane& pane);

  /// Returns whether the body does not rotate.
  bool at_rest() const { return frame_.direction.isZero(0.0); }

  /// Frames the sphere of that radius about the centre and the points. The camera starts at
  /// `azimuth` and orbits like the scene's camera; angles in rad.
  void frame(double azimuth, double elevation, double radius, std::vector<Eigen::Vector3d> points);

  const timeline::SolutionState& state_in(const timeline::FrameState& frame) const {
    return frame.solutions[solution_];
  }

  /// Returns the width in pixels of a thin line in a pane of this size.
  double hairline() const;

  /// Adds the name of an object that extends from the centre to `tip`, if there is room for it.
  void add_label(ViewContents& contents, const std::string& text, const Eigen::Vector3d& tip,
                 const Color& color) const;

  OverlayColors colors_;
  scene::CameraPath path_;
  bool shows_trail_, shows_labels_;
  double trail_length_;  ///< Duration of the trail in s.
  motion::FreeBody body_;
  PrincipalFrame frame_;

 private:
  std::size_t solution_;
  double orbit_;      ///< rad, of the camera in the whole video.
  Viewpoint home_{};  ///< At the start of the video.
  double radius_ = 0;
  std::vector<Eigen::Vector3d> points_;
  Framing framing_{};
};

}  // namespace twrench::picture
