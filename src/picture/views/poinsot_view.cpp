#include "picture/views/poinsot_view.h"

#include <twrench/body/shape.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace twrench::picture {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double elevation = 0.60;     // rad, of the camera above the plane
constexpr double momentum_end = 1.34;  // of L's arrow
constexpr double min_plane_radius = 0.95;
constexpr int curve_points = 120;

/// Returns the rotation that makes L point up; the azimuth is arbitrary.
Matrix3d with_up(const Vector3d& momentum) {
  if (momentum.isZero(0.0)) return Matrix3d::Identity();
  const Matrix3d frame = body::frame_with_z_along(momentum);
  Matrix3d m;
  m << frame.col(1).transpose(), frame.col(2).transpose(), frame.col(0).transpose();
  return m;
}

/// Radii of x . I x = 1 in units of the plane's distance or, at rest, of the largest radius.
Vector3d radii_of(const motion::FreeBody& body) {
  const Vector3d radii = body.principal().moments.cwiseSqrt().cwiseInverse();
  if (body.momentum().isZero(0.0)) return radii / radii.maxCoeff();
  const double G = body.momentum().stableNorm();
  return radii * (G / std::sqrt(body.omega().dot(body.momentum())));
}

/// rad: a curve through points farther apart would show corners and miss turns.
constexpr double widest_turn = 0.35;

}  // namespace

std::string PoinsotView::description(const timeline::Solution& solution,
                                     const PrincipalFrame& /*frame*/, scene::Language language) {
  constexpr scene::Phrase at_rest{"The body's inertia ellipsoid. The body is at rest.",
                                  "Legemets treghetsellipsoide. Legemet er i ro."};
  constexpr scene::Phrase rolls{
      "The body's inertia ellipsoid rolls without slipping on a plane that never moves, normal to "
      "L. It touches the plane at ω, the axis about which the body turns at that moment.",
      "Legemets treghetsellipsoide ruller uten å gli på et plan som aldri beveger seg, normalt på "
      "L. Den berører planet ved ω, aksen som legemet dreier om i det øyeblikket."};
  return (solution.body.momentum().isZero(0.0) ? at_rest : rolls).in(language);
}

PoinsotView::PoinsotView(const scene::Scene& scene,
                         const std::vector<timeline::Solution>& solutions, std::size_t solution,
                         const Layout::Pane& pane)
    : SolutionView(scene, solutions, solution, pane),
      view_from_space_(with_up(body_.momentum())),
      unit_(at_rest() ? 1 : body_.omega().dot(body_.momentum().stableNormalized())),
      radii_(radii_of(body_)) {
  if (frame_.level) annulus_ = motion::herpolhode_annulus(*frame_.level);
  plane_radius_ = std::max(1.25 * annulus_.outer, min_plane_radius);
  frame(path_.azimuth, elevation, radii_.maxCoeff(), extent());
  const std::vector<motion::Sample>& whole = solutions[solution].whole;
  const double apart = scene.motion.duration / static_cast<double>(whole.size() - 1);
  if (at_rest() || apart * body_.omega().norm() > widest_turn) return;
  for (const motion::Sample& sample : whole) herpolhode_.push_back(contact(sample));
}

/// Returns points that a camera should have in view in addition to the ellipsoid.
std::vector<Vector3d> PoinsotView::extent() const {
  if (at_rest()) return {};
  std::vector<Vector3d> points{{0, 1.1 * momentum_end, 0}};  // including its name
  for (int i = 0; i < 24; ++i) {
    const double angle = 2 * std::numbers::pi * i / 24;
    points.emplace_back(plane_radius_ * std::sin(angle), 1, plane_radius_ * std::cos(angle));
  }
  return points;
}

Matrix3d PoinsotView::ellipsoid(const Matrix3d& X) const {
  return view_from_space_ * X * body_.principal().axes * radii_.asDiagonal();
}

Vector3d PoinsotView::contact(const motion::Sample& sample) const {
  return view_from_space_ * (sample.X * sample.omega) / unit_;
}

/// A graticule about the axis of least moment that makes the ellipsoid's rolling visible.
void PoinsotView::add_grid(const Matrix3d& view_from_unit, DrawList& list) const {
  const Matrix3d normal_from_unit = view_from_unit.inverse().transpose();
  std::vector<DrawList::Point> line;
  const auto add = [&](double latitude, double longitude, double opacity) {
    const Vector3d unit(std::sin(latitude), std::cos(latitude) * std::cos(longitude),
                        std::cos(latitude) * std::sin(longitude));
    const Vector3d place = view_from_unit * unit;
    line.push_back({place,
                    hairline(),
                    {colors_.dim, opacity * shown(place, normal_from_unit * unit, list.eye())}});
  };
  constexpr double pi = std::numbers::pi, step = pi / 12;
  for (int i = 0; i < 12; ++i, list.line(line), line.clear()) {
    for (int k = 0; k <= curve_points; ++k)
      add(2 * pi * k / curve_points, i * step, i % 6 == 0 ? 0.75 : 0.3);
  }
  for (int i = -5; i <= 5; ++i, list.line(line), line.clear()) {
    for (int k = 0; k <= curve_points; ++k)
      add(i * step, 2 * pi * k / curve_points, i == 0 ? 0.75 : 0.3);
  }
}

void PoinsotView::add_polhode(const Matrix3d& X, DrawList& list) const {
  if (!frame_.level) return;
  const Matrix3d turned = view_from_space_ * X * frame_.axes;
  const motion::EnergyLevel& level = *frame_.level;
  std::vector<DrawList::Point> line;
  for (int i = 0; i <= 2 * curve_points; ++i) {
    const Vector3d mu = level.at(std::numbers::pi * i / curve_points);
    const Vector3d place = turned * mu.cwiseQuotient(level.moments) / level.energy;
    const double opacity = shown(place, turned * mu, list.eye());  // L is the normal there
    line.push_back({place, 2 * hairline(), {colors_.omega, opacity}});
  }
  list.line_on_halo(line, colors_.panel);
}

void PoinsotView::add_ring(double radius, double width, const Ink& ink, DrawList& list) const {
  std::vector<DrawList::Point> line;
  for (int i = 0; i <= curve_points; ++i) {
    const double angle = 2 * std::numbers::pi * i / curve_points;
    line.push_back(
        {{radius * std::sin(angle), 1, radius * std::cos(angle)}, width * hairline(), ink});
  }
  list.line(line);
}

void PoinsotView::add_plane(const timeline::SolutionState& instant, DrawList& list) const {
  list.disc(Vector3d::UnitY(), Vector3d::UnitY(), plane_radius_, {colors_.plane, 0.36},
            {colors_.plane, 0.22});
  add_ring(plane_radius_, 1.2, {colors_.plane, 0.9}, list);
  for (const double radius : {annulus_.inner, annulus_.outer}) {
    if (radius > 0.01) add_ring(radius, 1, {colors_.dim, 0.45}, list);
  }
  std::vector<DrawList::Point> line;
  for (const Vector3d& place : herpolhode_) {
    line.push_back({place, hairline(), {colors_.omega, 0.35}});
  }
  list.line(line);
  line.clear();
  for (const motion::Sample& sample : instant.trail) {
    if (!shows_trail_) break;
    const double age = instant.trail_age(sample, trail_length_);
    line.push_back(
        {contact(sample), (3 - 1.6 * age) * hairline(), {colors_.omega, std::pow(1 - age, 1.2)}});
  }
  list.line(line);
  const Vector3d now = contact(instant.sample);
  list.dot(now, 4.6 * hairline(), {colors_.panel, 0.9});
  list.dot(now, 3.4 * hairline(), {colors_.omega, 1});
}

void PoinsotView::add(const timeline::FrameState& state, ViewContents& contents) const {
  const timeline::SolutionState& instant = state_in(state);
  const Matrix3d view_from_unit = ellipsoid(instant.sample.X);
  const Ink ground{colors_.panel, colors_.panel_opacity};
  const Vector3d up = Vector3d::UnitY();
  DrawList& list = contents.translucent;
  if (!at_rest()) list.disc(up, up, plane_radius_, ground, ground);
  list.ellipsoid(view_from_unit, {colors_.plane, 0.40}, 0.9, ground);
  add_grid(view_from_unit, list);
  if (at_rest()) return;
  add_polhode(instant.sample.X, list);
  const Vector3d momentum = momentum_end * up, omega = contact(instant.sample);
  contents.opaque.arrow(Vector3d::Zero(), momentum, 0.018, {colors_.momentum});
  contents.opaque.arrow(Vector3d::Zero(), omega, 0.018, {colors_.omega});
  add_plane(instant, list);
  add_label(contents, "L", momentum, colors_.momentum);
  add_label(contents, "ω", omega, colors_.omega);
}

}  // namespace twrench::picture
