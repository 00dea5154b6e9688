#include "render/renderer.h"

#include "gl/framebuffer.h"
#include "render/background.h"
#include "render/component_panel.h"
#include "render/element.h"
#include "render/hud.h"
#include "render/layout.h"
#include "render/theme.h"
#include "render/wrench_view.h"

namespace twrench {
namespace {

Image empty_picture(const Scene& scene) {
  if (scene.look.transparent) return {scene.film.width, scene.film.height, 4};
  return background(scene.look, scene.film.width, scene.film.height);
}

}  // namespace

struct Renderer::Parts {
  Parts(gl::Context& context, const Scene& scene, const std::vector<Take>& takes);

  gl::Functions gl;
  gl::Framebuffer framebuffer;
  Typeface typeface;
  std::vector<std::unique_ptr<Element>> elements;  // in the order in which they are laid over
  const WrenchView* wrench;
  Image still;  // premultiplied where it is RGBA
};

Renderer::Parts::Parts(gl::Context& context, const Scene& scene, const std::vector<Take>& takes)
    : gl(context),
      framebuffer(gl, scene.film.width, scene.film.height, scene.look.samples),
      typeface(load_typeface(scene.overlay.font)),
      still(empty_picture(scene)) {
  const Layout layout = layout_of(scene);
  for (std::size_t i = 0; i < takes.size(); ++i) {
    auto view = std::make_unique<WrenchView>(gl, framebuffer, scene, i, layout.panes[i]);
    if (i == 0) wrench = view.get();
    elements.push_back(std::move(view));
  }
  const OverlayColors& colors = style_of(scene.look.theme).overlay;
  if (layout.components) {
    elements.push_back(std::make_unique<ComponentPanel>(scene, takes, layout, typeface, colors));
  }
  elements.push_back(std::make_unique<Hud>(scene, takes, layout, typeface, colors));
  for (const auto& element : elements) {
    for (const Layer& layer : element->still()) lay_over(still, layer);
  }
}

Renderer::Renderer(gl::Context& context, const Scene& scene, const std::vector<Take>& takes)
    : parts_(std::make_unique<Parts>(context, scene, takes)) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

Frame Renderer::draw(const Moment& moment) {
  Frame frame{parts_->still, {}};
  for (const auto& element : parts_->elements) {
    for (const Layer& layer : element->draw(moment)) {
      lay_over(frame.image, layer);
      frame.changed.push_back(layer.area());
    }
  }
  if (frame.image.channels == 4) {
    make_straight(frame.image, {0, 0, frame.image.width, frame.image.height});
  }
  return frame;
}

const Image& Renderer::still() const { return parts_->still; }
std::string Renderer::description() const { return gl::renderer_string(parts_->gl); }
Camera Renderer::camera(double film_time) const { return parts_->wrench->camera(film_time); }

}  // namespace twrench
