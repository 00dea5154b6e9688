#pragma once

#include "render/views/solution_view.h"

namespace twrench::render {

/// The momentum in the body frame. Its length G is constant, so it moves on a sphere, along a curve
/// of constant energy: around the axis of least or greatest moment or, close to the separatrix,
/// back and forth between the ends of the intermediate axis, which is the flip.
class MomentumView : public SolutionView {
 public:
  /// Shows one motion in `pane`, drawn through `framebuffer`, which must outlive the view.
  MomentumView(const gl::Functions& gl, const gl::Framebuffer& framebuffer,
               const scene::Scene& scene, const std::vector<timeline::Solution>& solutions,
               std::size_t solution, const Layout::Pane& pane);

  /// The sphere with its curves and axes, if the camera is fixed.
  std::vector<Layer> static_layers() override;

  /// The momentum and its trail.
  std::vector<PendingLayer> draw(const timeline::FrameState& state) override;

  std::vector<Label> labels(const timeline::FrameState& state) const override;

  /// Returns the position of a sample's momentum, on the unit sphere unless the method has left it.
  Eigen::Vector3d place_of(const motion::Sample& sample) const;

 private:
  void add_sphere();
  void add_level(const motion::EnergyLevel& level, double width, const Ink& ink);
  void add_separatrix();
  void add_momentum(const timeline::SolutionState& instant);
  template <typename Place>
  void add_curve(Place place, double width, const Ink& ink);

  Eigen::Matrix3d view_from_own_;  ///< From coordinates along the frame's axes to the picture's.
};

}  // namespace twrench::render
