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
                         std::span<const Eigen::Vector3d> points) {
  constexpr double field_of_view = 0.5;
  const double aspect = static_cast<double>(pane().focus.width) / pane().focus.height;
  azimuth_ = azimuth;
  elevation_ = elevation;
  framing_ = fitted({{0, 0, 1}, field_of_view, aspect, radius},
                    directions_along(azimuth, elevation, orbit_), points);
}

Camera SolutionView::camera(double video_time) const {
  Framing framing = framing_;
  framing.direction = direction_of(azimuth_ + path_.orbit * video_time, elevation_);
  return widened(frame_sphere(framing), pane().focus, pane().area);
}

double SolutionView::hairline() const {
  return std::max(1.0, 0.0022 * std::min(pane().area.width, pane().area.height));
}

void SolutionView::add_label(ViewContents& contents, const std::string& text,
                             const Eigen::Vector3d& tip, const scene::Color& color) const {
  if (!shows_labels_) return;
  auto label = label_at(text, contents.camera, pane().area, Eigen::Vector3d::Zero(), tip, color);
  if (label) contents.labels.push_back(std::move(*label));
}

}  // namespace twrench::picture
