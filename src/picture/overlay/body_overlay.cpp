#include "picture/overlay/body_overlay.h"

#include <twrench/motion/polhode.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "picture/look/emphasis.h"
#include "picture/overlay/track.h"
#include "picture/overlay/trail_point.h"

namespace twrench::picture {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// As multiples of the bounding radius.
constexpr double plane_distance = 1.18, longest_omega = 1.5, least_plane = 0.85;
constexpr double momentum_thickness = 0.017, omega_thickness = 0.015, axis_thickness = 0.010;
constexpr double trail_width = 0.016, plane_line = 0.004;

/// Returns points on the circle of that radius about `centre`, normal to `normal`.
std::vector<Vector3d> circle(const Vector3d& centre, const Vector3d& normal, double radius,
                             int count) {
  const Matrix3d frame = body::frame_with_z_along(normal);
  std::vector<Vector3d> points;
  for (int i = 0; i <= count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    points.emplace_back(centre + radius * (frame * Vector3d(std::cos(angle), std::sin(angle), 0)));
  }
  return points;
}

}  // namespace

BodyOverlay::BodyOverlay(const scene::Scene& scene, const motion::FreeBody& body, double radius)
    : colors_(emphasised(style_of(scene.look.theme).overlay, scene.overlay)),
      ellipsoid_(scene.overlay.shows(scene::Feature::inertia)
                     ? std::optional(scene::equal_ellipsoid(scene.body))
                     : std::nullopt),
      shows_axes_(scene.overlay.shows(scene::Feature::axes)),
      shows_momentum_(scene.overlay.shows(scene::Feature::momentum)),
      shows_omega_(scene.overlay.shows(scene::Feature::omega)),
      shows_plane_(scene.overlay.shows(scene::Feature::plane)),
      shows_trail_(scene.overlay.shows(scene::Feature::trail)),
      shows_labels_(scene.overlay.shows(scene::Feature::labels)),
      momentum_shaft_(momentum_thickness * thickness_of(scene.overlay, scene::Feature::momentum)),
      omega_shaft_(omega_thickness * thickness_of(scene.overlay, scene::Feature::omega)),
      axis_shaft_(axis_thickness * thickness_of(scene.overlay, scene::Feature::axes)),
      trail_width_(trail_width * thickness_of(scene.overlay, scene::Feature::trail)),
      radius_(radius),
      trail_length_(timeline::trail_length(scene)),
      trail_point_(trail_point(scene)),
      up_(body.momentum().stableNormalized()) {
  if (body.momentum().isZero(0.0)) {
    shows_momentum_ = shows_omega_ = shows_plane_ = false;
    return;
  }
  if (!body.is_rigid()) {
    // The tip of omega stays in no plane.
    const double fastest = scene::fastest_rate(body);
    shows_omega_ = shows_omega_ && fastest > 0;
    if (shows_omega_) scale_ = longest_omega * radius / fastest;
    omega_reach_ = longest_omega * radius;
    return;
  }
  const auto level =
      motion::level_through(body.principal().moments, body.principal().axes.transpose() * up_);
  const double outer = level ? motion::herpolhode_annulus(*level).outer : 0;
  const double height = body.omega().dot(up_);  // rad/s
  const double longest = std::max(height * std::hypot(1, outer), body.omega().norm());
  scale_ = radius * std::min(plane_distance / height, longest_omega / longest);
  plane_height_ = scale_ * height;
  omega_radius_ = outer * plane_height_;
  plane_radius_ = std::max(1.2 * omega_radius_, least_plane * radius);
}

std::vector<Vector3d> BodyOverlay::extent() const {
  std::vector<Vector3d> points;
  if (shows_momentum_) points.push_back(momentum_tip());
  if (ellipsoid_) {
    const double reach = body::bounding_radius(ellipsoid_->shape);
    for (int i = 0; i < 3; ++i) {
      for (const double side : {-1, 1}) points.emplace_back(side * reach * Vector3d::Unit(i));
    }
  }
  if (shows_omega_ && omega_reach_ > 0) {
    for (int i = 0; i < 3; ++i) {
      for (const double side : {-1, 1})
        points.emplace_back(side * omega_reach_ * Vector3d::Unit(i));
    }
  } else if (shows_omega_ || shows_plane_) {
    const double across = shows_plane_ ? plane_radius_ : omega_radius_;
    for (const Vector3d& point : circle(plane_height_ * up_, up_, across, 16)) {
      points.push_back(point);
    }
  }
  return points;
}

void BodyOverlay::draw(const timeline::SolutionState& instant, DrawList& opaque,
                       DrawList& translucent) const {
  const Matrix3d& X = instant.sample.X;
  const Vector3d centre = Vector3d::Zero();
  if (shows_axes_) {
    for (int i = 0; i < 3; ++i) {
      opaque.arrow(centre, axis_arrow_length() * X.col(i), axis_shaft(),
                   {colors_.axis[static_cast<std::size_t>(i)]});
    }
  }
  if (shows_momentum_) {
    opaque.arrow(centre, momentum_tip(), momentum_shaft(), {colors_.momentum});
  }
  if (shows_omega_) {
    opaque.arrow(centre, omega_tip(instant.sample), omega_shaft(), {colors_.omega},
                 omega_nearer(instant.sample));
  }
  if (ellipsoid_) draw_ellipsoid(X, translucent);
  if (shows_plane_) draw_plane(translucent);
  if (shows_trail_) draw_trail(instant, translucent);
}

/// Returns by how much omega is drawn nearer, so that it lies on L where the two nearly coincide.
/// They would otherwise enter each other along a jagged line.
double BodyOverlay::omega_nearer(const motion::Sample& sample) const {
  if (!shows_momentum_) return 0;
  constexpr double widest = 0.15;  // rad, at which the arrows are apart as far as one sees them
  const Vector3d omega = omega_tip(sample);
  const double angle = std::atan2(up_.cross(omega).norm(), up_.dot(omega));
  return 1.5 * (momentum_shaft() + omega_shaft()) * std::max(1 - angle / widest, 0.0);
}

void BodyOverlay::draw_plane(DrawList& translucent) const {
  const Vector3d centre = plane_height_ * up_;
  translucent.disc(centre, up_, plane_radius_, {colors_.plane, 0.22}, {colors_.plane, 0.10});
  std::vector<DrawList::Point> line;
  const auto add = [&](const Vector3d& place, double opacity) {
    line.push_back(
        {place, plane_line * radius_ * translucent.pixels(place), {colors_.plane, opacity}});
  };
  constexpr int rings = 4, spokes = 12;
  for (int ring = 1; ring <= rings; ++ring) {
    line.clear();
    for (const Vector3d& place : circle(centre, up_, plane_radius_ * ring / rings, 96)) {
      add(place, ring == rings ? 0.75 : 0.4);
    }
    translucent.line(line);
  }
  for (const Vector3d& rim : circle(centre, up_, plane_radius_, spokes)) {
    line.clear();
    for (const double share : {0.25, 0.5, 0.75, 1.0}) add(centre + share * (rim - centre), 0.3);
    translucent.line(line);
  }
}

/// As a shell of glass, with the ellipses in its planes of symmetry.
void BodyOverlay::draw_ellipsoid(const Matrix3d& X, DrawList& translucent) const {
  const Vector3d& radii = std::get<body::Ellipsoid>(ellipsoid_->shape).radii;
  const Matrix3d space_from_unit = X * ellipsoid_->body_from_part * radii.asDiagonal();
  translucent.ellipsoid(space_from_unit, {colors_.plane, 0.25}, 0.8);
  for (int i = 0; i < 3; ++i) {
    std::vector<DrawList::Point> line;
    for (const Vector3d& unit : circle(Vector3d::Zero(), Vector3d::Unit(i), 1, 96)) {
      const Vector3d place = space_from_unit * unit;
      line.push_back(
          {place, plane_line * radius_ * translucent.pixels(place), {colors_.plane, 0.6}});
    }
    translucent.line(line);
  }
}

void BodyOverlay::draw_trail(const timeline::SolutionState& instant, DrawList& translucent) const {
  const auto draw = [&](double width, const Color& color, const auto& place) {
    draw_track(instant, {width * radius_, trail_length_, color, colors_.panel}, place, translucent);
  };
  if (shows_plane_ && shows_omega_) {
    draw(0.6 * trail_width_, colors_.omega,
         [&](const motion::Sample& sample) { return omega_tip(sample); });
  }
  draw(trail_width_, colors_.trail,
       [&](const motion::Sample& sample) -> Vector3d { return sample.X * trail_point_; });
}

std::vector<Label> BodyOverlay::labels(const timeline::SolutionState& instant, const Camera& camera,
                                       const image::Area& pane) const {
  std::vector<Label> labels;
  if (!shows_labels_) return labels;
  const auto add = [&](const char* text, const Vector3d& tip, const Color& color, double shaft) {
    const double head = arrow_head_radius * shaft;
    if (auto label = label_at(text, camera, pane, Vector3d::Zero(), tip, color, head)) {
      labels.push_back(std::move(*label));
    }
  };
  static constexpr std::array names{"x", "y", "z"};
  for (std::size_t i = 0; shows_axes_ && i < 3; ++i) {
    const Vector3d tip = axis_arrow_length() * instant.sample.X.col(static_cast<Eigen::Index>(i));
    add(names[i], tip, colors_.axis[i], axis_shaft());
  }
  if (shows_momentum_) add("L", momentum_tip(), colors_.momentum, momentum_shaft());
  if (shows_omega_) add("ω", omega_tip(instant.sample), colors_.omega, omega_shaft());
  return labels;
}

}  // namespace twrench::picture
