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
      solution_(solution) {}

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
