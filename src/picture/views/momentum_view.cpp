#include "picture/views/momentum_view.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

#include "body/moments.h"
#include "scene/prediction.h"

namespace twrench::picture {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double lifted = 1.002;  // lifts curves off the facets of the sphere
constexpr double axis_end = 1.24;
constexpr double named = 1.12;  // position of an axis' name, in units of axis_end

/// The picture's axes, right-handed, with x to the right: the axis of least moment points up, and
/// the intermediate one towards the viewer.
Matrix3d picture_axes(const Matrix3d& axes) {
  Matrix3d m;
  m << axes.col(0).cross(axes.col(1)).transpose(), axes.col(0).transpose(), axes.col(1).transpose();
  return m;
}

/// The direction from which the flip is seen best, along the frame's own axes: slightly beside the
/// intermediate axis, on the side of `mu`.
Vector3d eye_direction(const Vector3d& mu) {
  const Vector3d side = mu.unaryExpr([](double c) { return c < 0 ? -1.0 : 1.0; });
  return side.cwiseProduct(Vector3d(0.36, 0.80, 0.50));
}

bool has_ranks(const Vector3d& moments) {
  return !body::are_equal_moments(moments[0], moments[1]) &&
         !body::are_equal_moments(moments[1], moments[2]);
}

}  // namespace

std::string MomentumView::description(const timeline::Solution& solution,
                                      const PrincipalFrame& frame, scene::Language language) {
  using scene::Phrase;
  if (frame.direction.isZero(0.0)) {
    return Phrase("The body is at rest: it has no angular momentum.",
                  "Legemet er i ro: det har ingen dreieimpuls.")
        .in(language);
  }
  const std::string sphere =
      Phrase(
          "The angular momentum L, seen from the body. Its length is constant, so its tip stays on "
          "a sphere; ",
          "Dreieimpulsen L, sett fra legemet. Lengden er konstant, så spissen blir på en kule; ")
          .in(language);
  if (solution.body.energy_loss() > 0) {
    return sphere + Phrase(
                        "the body loses energy, so it crosses the curves of constant energy, "
                        "down to the least.",
                        "legemet taper energi, så den krysser kurvene med konstant energi, ned "
                        "til den minste.")
                        .in(language);
  }
  if (solution.body.is_rigid() && !frame.level) {
    return sphere + Phrase("as all moments are equal, it stays where it is.",
                           "siden alle momentene er like, blir den der den er.")
                        .in(language);
  }
  const std::string level = sphere + Phrase("the energy is constant, so it stays on one curve. ",
                                            "energien er konstant, så den blir på én kurve. ")
                                         .in(language);
  if (!solution.body.is_rigid()) {
    return level + Phrase("A wheel in the body moves the curves. Dots are steady rotations.",
                          "Et hjul i legemet flytter kurvene. Prikker er jevne rotasjoner.")
                       .in(language);
  }
  if (solution.flips) {
    return level + Phrase(
                       "Close to the bold curve this leads from one end of the middle axis to the "
                       "other: the body turns over.",
                       "Nær den tykke kurven fører den fra den ene enden av den midterste aksen "
                       "til den andre: legemet snur.")
                       .in(language);
  }
  const auto axis = static_cast<std::size_t>(frame.level->axis);
  if (!has_ranks(solution.body.principal().moments)) {
    return level + Phrase("It stays on one side of the body, about the {} axis.",
                          "Den blir på én side av legemet, om {}-aksen.")
                       .in(language, frame.names[axis]);
  }
  return level + Phrase("It stays on one side of the body, about the {} axis.",
                        "Den blir på én side av legemet, om den {} aksen.")
                     .in(language, scene::rank_name(axis, language));
}

MomentumView::MomentumView(const scene::Scene& scene,
                           const std::vector<timeline::Solution>& solutions, std::size_t solution,
                           const Layout::Pane& pane)
    : SolutionView(scene, solutions, solution, pane),
      view_from_own_(picture_axes(frame_.axes) * frame_.axes),
      axis_names_(frame_.names) {
  if (has_ranks(body_.principal().moments)) {
    for (std::size_t i = 0; i < 3; ++i) axis_names_[i] = scene::rank_name(i, scene.language);
  }
  const Vector3d from = view_from_own_ * eye_direction(frame_.direction);
  std::vector<Vector3d> tips;
  for (int i = 0; i < 3; ++i) tips.emplace_back(named * axis_end * view_from_own_.col(i));
  frame(std::atan2(from.x(), from.z()), std::atan2(from.y(), std::hypot(from.x(), from.z())), 1,
        tips);
  curves_ = sphere_curves(body_, frame_);
  if (scene.overlay.shows(scene::Feature::phase)) cap_ = phase_cap(body_, frame_);
}

Vector3d MomentumView::place_of(const motion::Sample& sample) const {
  const double G = body_.momentum().stableNorm();
  if (G == 0) return Vector3d::Zero();
  // X^-1 L is I omega of a rigid body, for methods that leave SO(3) too.
  return view_from_own_ * (frame_.axes.transpose() * (sample.X.inverse() * body_.momentum() / G));
}

void MomentumView::add_curve(const SphereCurves::Curve& curve, double width, const Ink& ink,
                             DrawList& list) const {
  std::vector<DrawList::Point> line;
  for (const Vector3d& own : curve) {
    const Vector3d point = view_from_own_ * own;
    const double opacity = ink.opacity * shown(point, point, list.eye());
    line.push_back({lifted * point, width * hairline(), {ink.color, opacity}});
  }
  list.line(line);
}

void MomentumView::add_cap(DrawList& list) const {
  constexpr double opacity = 0.35;
  std::vector<Vector3d> rim;
  for (const Vector3d& own : cap_->rim) rim.emplace_back(view_from_own_ * own);
  list.cap(view_from_own_ * cap_->middle, rim, [&](const Vector3d& point) -> Ink {
    return {colors_.momentum, opacity * shown(point, point, list.eye())};
  });
}

void MomentumView::add_sphere(ViewContents& contents) const {
  for (int i = 0; i < 3; ++i) {
    const Vector3d axis = view_from_own_.col(i);
    contents.opaque.arrow(0.98 * axis, axis_end * axis, 0.016,
                          {frame_.colors[static_cast<std::size_t>(i)]});
  }
  DrawList& list = contents.translucent;
  list.ellipsoid(Matrix3d::Identity(), {colors_.plane, 0.22}, 0.75,
                 {colors_.panel, colors_.panel_opacity});
  if (cap_) add_cap(list);
  for (const auto& [curve, axis] : curves_.levels) {
    add_curve(curve, 1.25, {frame_.colors[axis], 0.95}, list);
  }
  if (!curves_.path.empty()) add_curve(curves_.path, 1.5, {colors_.momentum, 0.85}, list);
  for (const SphereCurves::Curve& curve : curves_.separatrices) {
    add_curve(curve, 1.7, {colors_.text, 0.95}, list);
  }
  for (const Vector3d& own : curves_.equilibria) {
    const Vector3d point = view_from_own_ * own;
    list.dot(lifted * point, 3 * hairline(), {colors_.text, shown(point, point, list.eye())});
  }
}

void MomentumView::add_momentum(const timeline::SolutionState& instant, const std::string& name,
                                const Color& color, ViewContents& contents) const {
  DrawList& list = contents.translucent;
  const auto fading = [&](const Vector3d& point, double opacity) {
    return opacity * shown(point, point, list.eye());
  };
  std::vector<DrawList::Point> line;
  for (const motion::Sample& sample : instant.trail) {
    if (!shows_trail_) break;
    const double age = instant.trail_age(sample, trail_length_);
    const Vector3d point = lifted * place_of(sample);
    line.push_back(
        {point, (3.2 - 2 * age) * hairline(), {color, fading(point, std::pow(1 - age, 1.2))}});
  }
  list.line_on_halo(line, colors_.panel);
  const Vector3d now = place_of(instant.sample);
  list.line(std::array<DrawList::Point, 2>{{{Vector3d::Zero(), hairline(), {color, 0.15}},
                                            {now, 1.5 * hairline(), {color, fading(now, 0.7)}}}});
  const double clear = 0.45 + 0.55 * fading(now, 1);  // remains visible on the far side
  list.dot(now, 5.2 * hairline(), {colors_.panel, 0.9 * clear});
  list.dot(now, 4.0 * hairline(), {color, clear});
  add_label(contents, name, now, color);
}

void MomentumView::add_still(ViewContents& contents) const {
  if (path_.orbit == 0) add_sphere(contents);
}

void MomentumView::add(const timeline::FrameState& state, ViewContents& contents) const {
  if (path_.orbit != 0) add_sphere(contents);
  add_axis_labels(contents);
  if (at_rest()) return;
  const bool compares = state.solutions.size() == 2;
  // A is the main motion and is therefore drawn over B.
  if (compares) add_momentum(state.solutions[1], "B", colors_.omega, contents);
  add_momentum(state_in(state), compares ? "A" : "L", colors_.momentum, contents);
}

void MomentumView::add_axis_labels(ViewContents& contents) const {
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3d tip = axis_end * view_from_own_.col(static_cast<Eigen::Index>(i));
    add_label(contents, axis_names_[i], tip, frame_.colors[i]);
  }
}

}  // namespace twrench::picture
