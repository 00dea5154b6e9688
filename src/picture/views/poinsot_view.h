#pragma once

#include "picture/views/solution_view.h"
#include "scene/phrase.h"

namespace twrench::picture {

/// Poinsot's construction: the inertia ellipsoid x . I x = 1, which rotates with the body about its
/// fixed centre, rolls without slipping on the invariable plane. The contact point omega / sqrt(2T)
/// traces the polhode on the ellipsoid and the herpolhode on the plane (Goldstein, Classical
/// Mechanics, section 5.6).
///
/// Lengths are in units of the plane's distance sqrt(2T)/G from the centre, and L points up: the
/// plane is seen from above, with the contact point below it.
class PoinsotView : public SolutionView {
 public:
  static constexpr scene::Phrase heading{"the ellipsoid rolls", "ellipsoiden ruller"};
  static std::string description(const timeline::Solution& solution, const PrincipalFrame& frame,
                                 scene::Language language);

  /// Shows one motion in `pane`.
  PoinsotView(const scene::Scene& scene, const std::vector<timeline::Solution>& solutions,
              std::size_t solution, const Layout::Pane& pane);

  void add(const timeline::FrameState& state, ViewContents& contents) const override;

  /// Returns the ellipsoid in the pose X, as the matrix that maps the unit sphere to it.
  Eigen::Matrix3d ellipsoid(const Eigen::Matrix3d& X) const;

  /// Returns the contact point with the plane, whose height is 1.
  Eigen::Vector3d contact(const motion::Sample& sample) const;

 private:
  std::vector<Eigen::Vector3d> extent() const;
  void add_grid(const Eigen::Matrix3d& view_from_unit, DrawList& list) const;
  void add_polhode(const Eigen::Matrix3d& X, DrawList& list) const;
  void add_plane(const timeline::SolutionState& instant, DrawList& list) const;
  void add_ring(double radius, double width, const Ink& ink, DrawList& list) const;

  Eigen::Matrix3d view_from_space_;
  /// Unit of omega, 2T/G, in rad/s.
  double unit_;
  /// Radii of the ellipsoid.
  Eigen::Vector3d radii_;
  /// Radii of the herpolhode.
  motion::Annulus annulus_{0, 0};
  double plane_radius_;
  /// The full curve, unless it is too dense to be legible.
  std::vector<Eigen::Vector3d> herpolhode_;
};

}  // namespace twrench::picture
