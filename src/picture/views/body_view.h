#pragma once

#include "picture/body/body_model.h"
#include "picture/look/theme.h"
#include "picture/overlay/axis_tip.h"
#include "picture/overlay/body_overlay.h"
#include "picture/overlay/fixed_stars.h"
#include "picture/overlay/force_arrows.h"
#include "picture/overlay/torque_arcs.h"
#include "picture/views/blur_sampling.h"
#include "picture/views/view.h"

namespace twrench::picture {

/// The rotating body, seen by the scene's camera. If the camera moves with a turning frame, a trail
/// is the path in that frame, and motion blur is that of the motion in it.
class BodyView final : public View {
 public:
  /// The floor below the body.
  struct Floor {
    FloorStyle style;
    /// Whether it has the pool of light. If not, it keeps the colour of a flat background, and only
    /// shadow and reflection show it.
    bool is_lit;
  };

  /// Shows the motion with that index in `pane`.
  BodyView(const scene::Scene& scene, const std::vector<timeline::Solution>& solutions,
           std::size_t solution, const Layout::Pane& pane);

  /// The same without a surface, for a body of that bounding radius in cm.
  BodyView(const scene::Scene& scene, const std::vector<timeline::Solution>& solutions,
           std::size_t solution, const Layout::Pane& pane, double radius);

  Viewpoint viewpoint(double video_time) const override;
  Camera camera_from(const Viewpoint& from) const override;
  Camera in_space(const Camera& camera, const timeline::FrameState& state) const override;
  void add_still(ViewContents& contents) const override;
  void add(const timeline::FrameState& state, ViewContents& contents) const override;

  /// Returns how the camera of a frame has turned: for the scene's star_trail, or while the shutter
  /// is open. `camera` is that of the frame, for coordinates in space.
  FixedStars::Turning turning(const timeline::FrameState& state, const Camera& camera) const;

  const BodyModel& body() const { return body_; }
  /// Returns nothing without motion blur.
  const std::optional<BlurSampling>& sampling() const { return sampling_; }
  /// Returns nothing if no floor is seen.
  const std::optional<Floor>& floor() const { return floor_; }

 private:
  void add_surroundings(const scene::Scene& scene);
  Eigen::Matrix3d frame_at(const timeline::FrameState& state, double video_time,
                           const motion::Sample& sample) const;
  Eigen::Matrix3d camera_from_space(const timeline::FrameState& state, double video_time,
                                    const motion::Sample& sample) const;
  timeline::SolutionState relative(const timeline::FrameState& state) const;
  FixedStars::Turning turning_in_shutter(const timeline::FrameState& state) const;
  double shown_radius() const;
  Framing framing_of(const scene::Scene& scene, const timeline::Solution& solution) const;

  std::size_t solution_;
  motion::FreeBody motion_;
  scene::Frame frame_;
  double radius_;  ///< Bounding radius of the body in every pose, in cm.
  BodyOverlay overlay_;
  std::optional<ForceArrows> forces_;
  std::optional<TorqueArcs> torques_;
  std::optional<AxisTip> tip_;
  scene::CameraPath path_;
  Framing framing_;  ///< Keeps the overlay in view too; its direction moves.
  BodyModel body_{};
  std::optional<BlurSampling> sampling_;
  std::optional<Floor> floor_;       ///< For a camera at rest in space.
  std::optional<FixedStars> stars_;  ///< Those of the theme, or others that show how space turns.
  bool turns_;                       ///< Whether the camera turns throughout the scene.
  double half_open_;                 ///< Half the time in s of video that the shutter is open.
  double speed_;                     ///< Seconds of motion per second of video.
};

}  // namespace twrench::picture
