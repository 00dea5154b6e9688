#include "picture/overlay/axis_tip.h"

#include <algorithm>

#include "picture/look/emphasis.h"
#include "picture/overlay/track.h"
#include "scene/reference_frame.h"

namespace twrench::picture {
namespace {

using Eigen::Vector3d;

// As multiples of the bounding radius.
constexpr double tip_distance = 1.2, longest_at_tip = 0.7, least_at_tip = 0.2,
                 shortest_at_tip = 0.02, tip_force_shaft = 0.016, axis_shaft = 0.009,
                 path_width = 0.02, up_dot = 0.016;

constexpr double sum_width = 1.7;  // in shafts of the others: it may lie on one of them

}  // namespace

AxisTip::AxisTip(const scene::Scene& scene, const timeline::Solution& solution, double radius)
    : forces_(solution.body),
      shown_(shown_forces(scene.overlay, forces_on_tip())),
      colors_(style_of(scene.look.theme).overlay),
      is_dimmed_(is_dimmed(scene.overlay, scene::Feature::tip)),
      thickness_(thickness_of(scene.overlay, scene::Feature::tip)),
      trail_length_(timeline::trail_length(scene)),
      radius_(radius),
      up_(solution.body.momentum().stableNormalized()) {
  constexpr std::size_t stride = 4;    // of the samples, which are finer than needed here
  double strongest = 0, farthest = 0;  // farthest: of the tip from L, as a fraction of its distance
  for (const motion::Sample& sample : solution.whole) {
    const auto [centrifugal, coriolis] = forces_.at(sample);
    strongest =
        std::max({strongest, centrifugal.norm(), coriolis.norm(), (centrifugal + coriolis).norm()});
    farthest = std::max(farthest, (sample.X * forces_.axis() - up_).norm());
  }
  const double momentum = solution.body.momentum().norm();
  constexpr double rounding = 1e-12;  // of the forces at a large tilt
  if (strongest > rounding * momentum * momentum / solution.body.principal().moments[0]) {
    const double longest =
        std::clamp(farthest * distance(), least_at_tip * radius, longest_at_tip * radius);
    scale_ = longest * distance() / strongest;
  }
  for (std::size_t i = 0; i < solution.whole.size(); i += stride) {
    const motion::Sample& sample = solution.whole[i];
    const Vector3d tip = distance() * forces_.axis();
    const auto [centrifugal, coriolis] = forces_.at(sample);
    const auto frame =
        scene::reference_frame(scene::Frame::rotating, solution.body, sample).attitude;
    for (const Vector3d& force : {centrifugal, coriolis, Vector3d(centrifugal + coriolis)}) {
      const Vector3d end = tip + scale_ / distance() * force;
      extent_.emplace_back(frame.transpose() * (sample.X * end));
    }
  }
}

double AxisTip::distance() const { return tip_distance * radius_; }

void AxisTip::draw(const timeline::SolutionState& instant, DrawList& opaque,
                   DrawList& translucent) const {
  const auto shown = [&](const Color& color) {
    return is_dimmed_ ? dimmed(color, colors_) : color;
  };
  const auto tip_at = [&](const motion::Sample& sample) -> Vector3d {
    return distance() * (sample.X * forces_.axis());
  };
  const Vector3d tip = tip_at(instant.sample);
  opaque.arrow(Vector3d::Zero(), tip, axis_shaft * radius_, {shown(colors_.dim)});
  const auto [centrifugal, coriolis] = forces_.at(instant.sample);
  const double shaft = tip_force_shaft * thickness_ * radius_;
  for (const Force kind : shown_) {
    const Vector3d force = kind == Force::centrifugal ? centrifugal
                           : kind == Force::coriolis  ? coriolis
                                                      : Vector3d(centrifugal + coriolis);
    const Vector3d arrow = scale_ / distance() * (instant.sample.X * force);
    if (arrow.norm() < shortest_at_tip * radius_) continue;
    opaque.arrow(tip, tip + arrow, kind == Force::sum ? sum_width * shaft : shaft,
                 {shown(color_of(kind, colors_))});
  }
  const Vector3d up = distance() * up_;
  translucent.dot(up, up_dot * radius_ * translucent.pixels(up), {shown(colors_.momentum)});
  draw_track(
      instant,
      {path_width * thickness_ * radius_, trail_length_, shown(colors_.trail), colors_.panel},
      tip_at, translucent);
}

}  // namespace twrench::picture
