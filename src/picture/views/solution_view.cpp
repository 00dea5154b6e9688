#include "picture/views/solution_view.h"

#include <algorithm>

namespace twrench::picture {

SolutionView::SolutionView(const scene::Scene& scene,
                           const std::vector<timeline::Solution>& solutions, std::size_t solution,
                           const Layout::Pane& pane)
    : View(pane),
      colors_(style_of(scene.look.theme).overlay),
      path_(scene.camera),
      shows_trail_(scene.overlay.shows(scene::Feature::trail)),
      shows_labels_(pane.named && scene.overlay.shows(scene::Feature::labels)),
      trail_length_(timeline::trail_length(scene)),
      body_(solutions[solution].body),
      frame_(body_, colors_),
      solution_(solution),
      orbit_(scene.camera.orbit * scene.motion.duration / scene.film.speed) {}

void SolutionView::frame(double azimuth, double elevation, double radius,
                         std::vector<Eigen::Vector3d> points) {
  radius_ = radius;
  points_ = std::move(points);
  set_home(azimuth, elevation);
}

void SolutionView::set_home(double azimuth, double elevation) {
  constexpr double field_of_view = 0.5;
  const double aspect = static_cast<double>(pane().focus.width) / pane().focus.height;
  home_ = {azimuth, elevation};
  framing_ = fitted({{0, 0, 1}, field_of_view, aspect, radius_},
                    directions_along(azimuth, elevation, orbit_), points_);
}

Viewpoint SolutionView::viewpoint(double video_time) const {
  return {home_.azimuth + path_.orbit * video_time, home_.elevation};
}

Camera SolutionView::camera_from(const Viewpoint& from) const {
  return widened(frame_sphere(seen_from(framing_, from)), pane().focus, pane().area);
}

double SolutionView::hairline() const {
  return std::max(pane().thinnest, 0.0022 * std::min(pane().area.width, pane().area.height));
}

void SolutionView::add_label(ViewContents& contents, const std::string& text,
                             const Eigen::Vector3d& tip, const Color& color) const {
  if (!shows_labels_) return;
  auto label = label_at(text, contents.camera, pane().area, Eigen::Vector3d::Zero(), tip, color);
  if (label) contents.labels.push_back(std::move(*label));
}

}  // namespace twrench::picture
