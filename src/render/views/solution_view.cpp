#include "render/views/solution_view.h"

namespace twrench::render {

SolutionView::SolutionView(const gl::Functions& gl, const gl::Framebuffer& framebuffer,
                           const scene::Scene& scene,
                           const std::vector<timeline::Solution>& solutions, std::size_t solution,
                           const Layout::Pane& pane)
    : colors_(style_of(scene.look.theme).overlay),
      path_(scene.camera),
      shows_trail_(scene.overlay.shows(scene::Feature::trail)),
      shows_labels_(pane.named && scene.overlay.shows(scene::Feature::labels)),
      trail_length_(timeline::trail_length(scene)),
      body_(solutions[solution].body),
      frame_(body_, colors_),
      pane_(pane),
      pad_(gl, framebuffer, pane.area),
      solution_(solution),
      orbit_(scene.camera.orbit * scene.motion.duration / scene.film.speed) {}

void SolutionView::frame(double azimuth, double elevation, double radius,
                         std::span<const Eigen::Vector3d> points) {
  constexpr double field_of_view = 0.5;
  const double aspect = static_cast<double>(pane_.focus.width) / pane_.focus.height;
  azimuth_ = azimuth;
  elevation_ = elevation;
  framing_ = fitted({{0, 0, 1}, field_of_view, aspect, radius},
                    directions_along(azimuth, elevation, orbit_), points);
}

Camera SolutionView::camera(double video_time) const {
  Framing framing = framing_;
  framing.direction = direction_of(azimuth_ + path_.orbit * video_time, elevation_);
  return widened(frame_sphere(framing), pane_.focus, pane_.area);
}

void SolutionView::add_label(std::vector<Label>& labels, const Camera& camera,
                             const std::string& text, const Eigen::Vector3d& tip,
                             const scene::Color& color) const {
  if (!shows_labels_) return;
  auto label = label_at(text, camera, pane_.area, Eigen::Vector3d::Zero(), tip, color);
  if (label) labels.push_back(std::move(*label));
}

std::vector<PendingLayer> SolutionView::layers() const {
  std::vector<PendingLayer> layers;
  layers.push_back(pad_.layer());
  return layers;
}

}  // namespace twrench::render
