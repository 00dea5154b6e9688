#pragma once

#include "picture/views/solution_view.h"
#include "picture/views/sphere_curves.h"
#include "scene/phrase.h"

namespace twrench::picture {

/// The momentum in the body frame. Its length G is constant, so it moves on a sphere, along a curve
/// of constant energy: around the axis of least or greatest moment or, close to the separatrix,
/// back and forth between the ends of the intermediate axis, which is the flip.
class MomentumView : public SolutionView {
 public:
  static constexpr scene::Phrase heading{"L, seen from the body", "L, sett fra legemet"};
  static std::string description(const timeline::Solution& solution, const PrincipalFrame& frame,
                                 scene::Language language);

  /// Shows one motion in `pane`.
  MomentumView(const scene::Scene& scene, const std::vector<timeline::Solution>& solutions,
               std::size_t solution, const Layout::Pane& pane);

  /// The sphere with its curves and axes, if the camera is fixed.
  void add_still(ViewContents& contents) const override;

  /// The momentum and its trail; of two motions, A and B.
  void add(const timeline::FrameState& state, ViewContents& contents) const override;

  /// Returns the rotation from body axes to the picture's coordinates.
  Eigen::Matrix3d view_from_body() const { return view_from_own_ * frame_.axes.transpose(); }

  /// Returns the position of a sample's momentum, on the unit sphere unless the method has left it.
  Eigen::Vector3d place_of(const motion::Sample& sample) const;

 private:
  void add_sphere(ViewContents& contents) const;
  void add_cap(DrawList& list) const;
  void add_axis_labels(ViewContents& contents) const;
  void add_momentum(const timeline::SolutionState& instant, const std::string& name,
                    const Color& color, ViewContents& contents) const;
  void add_curve(const SphereCurves::Curve& curve, double width, const Ink& ink,
                 DrawList& list) const;

  Eigen::Matrix3d view_from_own_;  ///< From coordinates along the frame's axes to the picture's.
  std::array<std::string, 3> axis_names_;  ///< Least, middle, greatest, unless moments are equal.
  SphereCurves curves_;
  std::optional<Cap> cap_;  ///< The geometric phase, if it is shown.
};

}  // namespace twrench::picture
