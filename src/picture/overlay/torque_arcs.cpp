#include "picture/overlay/torque_arcs.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "picture/look/emphasis.h"
#include "picture/look/force_style.h"

namespace twrench::picture {
namespace {

using Eigen::Vector3d;

// As multiples of the bounding radius.
constexpr double arc_radius = 1.12, longest_arc = 1.25, shortest_arc = 0.03, arc_shaft = 0.028,
                 circle_line = 0.005;
constexpr double circle_opacity = 0.4;
constexpr int points_of_circle = 96;
// In rad.
constexpr double gap_at_start = 0.08, arc_step = 0.04, widest_arc = 2.9;

/// Returns the distance in cm of a place from the eye, along the direction in which it looks.
double depth_of(const Camera& camera, const Vector3d& place) {
  return camera.projection.row(3) * (camera.view * place.homogeneous());
}

/// Returns the arc from an angle onwards that is `length` pixels long on the screen. It goes in the
/// direction of the sign of `turn`, and ends early rather than behind the eye.
std::vector<Vector3d> arc_of_length(const TorqueArcs::Circle& circle, double from, double turn,
                                    double length, const Camera& camera, const image::Area& pane) {
  constexpr double least_depth = 1e-3;  // as a fraction of the distance
  std::vector<Vector3d> path{circle.at(from)};
  double rest = length;
  for (double angle = arc_step; rest > 0 && angle < widest_arc; angle += arc_step) {
    const Vector3d next = circle.at(from + std::copysign(angle, turn));
    if (depth_of(camera, next) < least_depth * camera.distance) break;
    const double piece =
        (pixel_of(camera, pane, next) - pixel_of(camera, pane, path.back())).norm();
    const double share = piece > rest ? rest / piece : 1;
    path.emplace_back(path.back() + share * (next - path.back()));
    rest -= piece;
  }
  return path;
}

}  // namespace

TorqueArcs::TorqueArcs(const scene::Scene& scene, const timeline::Solution& solution, double radius)
    : torque_(scene, solution.body),
      shows_labels_(scene.overlay.shows(scene::Feature::labels)),
      shaft_(arc_shaft * thickness_of(scene.overlay, scene::Feature::torques)),
      radius_(radius) {
  const OverlayColors& colors = style_of(scene.look.theme).overlay;
  const auto shown = [&](const Color& color) {
    return is_dimmed(scene.overlay, scene::Feature::torques) ? dimmed(color, colors) : color;
  };
  further_ = shown(color_of_further(colors));
  back_ = shown(color_of_back(colors));
  faint_ = shown(colors.dim);
  const double strongest = torque_.strongest(solution.whole);
  if (strongest > 0) scale_ = longest_arc * radius / strongest;
}

double TorqueArcs::bounding_radius() const {
  return (arc_radius + arrow_head_radius * shaft_) * radius_;
}

Vector3d TorqueArcs::Circle::at(double angle) const {
  return radius * (std::cos(angle) * start + std::sin(angle) * quarter);
}

TorqueArcs::Circle TorqueArcs::circle(const motion::Sample& sample) const {
  const Vector3d start = sample.X * torque_.longer_end();
  const Vector3d about = sample.X * torque_.axes(sample).about;
  return {start, about.cross(start), arc_radius * radius_};
}

std::vector<TorqueArcs::Arc> TorqueArcs::arcs(const motion::Sample& sample, const Camera& camera,
                                              const image::Area& pane) const {
  const Circle whole = circle(sample);
  const double pixels_per_cm =
      0.5 * camera.projection(1, 1) * pane.height / depth_of(camera, Vector3d::Zero());
  const auto [further, back] = torque_.sides(sample);
  std::vector<Arc> arcs;
  const auto add = [&](double torque, double from, const Color& color) {
    const double length = scale_ * std::abs(torque);
    if (length < shortest_arc * radius_) return;
    arcs.push_back({arc_of_length(whole, from, torque, length * pixels_per_cm, camera, pane), color,
                    torque > 0});
  };
  add(further, gap_at_start, further_);
  add(back, -0.5 * std::numbers::pi - gap_at_start, back_);
  return arcs;
}

void TorqueArcs::draw(const motion::Sample& sample, const Camera& camera, const image::Area& pane,
                      DrawList& opaque, DrawList& translucent) const {
  const std::vector<Arc> shown = arcs(sample, camera, pane);
  for (const Arc& arc : shown) opaque.arrow(arc.path, shaft_ * radius_, {arc.color});
  if (shown.empty()) return;
  const double length = scale_ * torque_.sides(sample).larger() / radius_;
  const double opacity = circle_opacity * std::min((length - shortest_arc) / shortest_arc, 1.0);
  const Circle whole = circle(sample);
  std::vector<DrawList::Point> line;
  for (int i = 0; i <= points_of_circle; ++i) {
    const Vector3d place = whole.at(2 * std::numbers::pi * i / points_of_circle);
    line.push_back({place, circle_line * radius_ * translucent.pixels(place), {faint_, opacity}});
  }
  translucent.line(line);
}

std::vector<Label> TorqueArcs::labels(const motion::Sample& sample, const Camera& camera,
                                      const image::Area& pane) const {
  std::vector<Label> labels;
  if (!shows_labels_) return labels;
  const auto [further, back] = torque_.names(sample);
  for (const Arc& arc : arcs(sample, camera, pane)) {
    const std::string& name = arc.is_further ? further : back;
    if (name.empty()) continue;
    const Vector3d& middle = arc.path[arc.path.size() / 2];
    auto label = label_at(name, camera, pane, Vector3d::Zero(), middle, arc.color);
    if (label) labels.push_back(std::move(*label));
  }
  return labels;
}

}  // namespace twrench::picture
