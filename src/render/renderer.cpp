#include "render/renderer.h"

#include <algorithm>
#include <chrono>
#include <deque>
#include <iterator>
#include <optional>

#include "canvas/font.h"
#include "gl/framebuffer.h"
#include "render/blank_frames.h"
#include "render/compose/element.h"
#include "render/compose/label_painter.h"
#include "render/compose/layout.h"
#include "render/hud/component_panel.h"
#include "render/hud/curve_panel.h"
#include "render/hud/force_legend.h"
#include "render/hud/hud.h"
#include "render/hud/moments_panel.h"
#include "render/hud/tilt_panel.h"
#include "render/look/background.h"
#include "render/look/theme.h"
#include "render/views/body_view.h"
#include "render/views/momentum_view.h"
#include "render/views/poinsot_view.h"

namespace twrench::render {
namespace {

using namespace std::chrono_literals;

image::Image empty_picture(const scene::Scene& scene) {
  if (scene.look.transparent) return {scene.film.width, scene.film.height, 4};
  return background(scene.look, scene.film.width, scene.film.height);
}

/// Composites layers in order: each as soon as it and all below it are ready.
class Composition {
 public:
  explicit Composition(image::Frame blank) : frame_(std::move(blank)) {}

  void add(PendingLayer layer) {
    layers_.push_back(std::move(layer));
    while (!layers_.empty() && layers_.front().wait_for(0s) == std::future_status::ready) {
      composite_first();
    }
  }

  /// Returns the frame when all layers are composited.
  image::Frame finish() {
    while (!layers_.empty()) composite_first();
    if (frame_.image.channels == 4) {
      unpremultiply(frame_.image, {0, 0, frame_.image.width, frame_.image.height});
    }
    return std::move(frame_);
  }

 private:
  void composite_first() {
    const Layer layer = layers_.front().get();
    layers_.pop_front();
    frame_.damage.push_back(composite_over(frame_.image, layer));
  }

  image::Frame frame_;
  std::deque<PendingLayer> layers_;
};

}  // namespace

struct Renderer::Parts {
  Parts(gl::Context& context, const scene::Scene& scene,
        const std::vector<timeline::Solution>& solutions, std::optional<gl::ReadMode> mode);

  gl::Functions gl;
  gl::Framebuffer framebuffer;
  canvas::Typeface typeface;
  std::vector<std::unique_ptr<Element>> elements;  // in compositing order
  std::optional<LabelPainter> label_painter;
  const SpaceView* first = nullptr;
  std::optional<BlankFrames> blank;
};

Renderer::Parts::Parts(gl::Context& context, const scene::Scene& scene,
                       const std::vector<timeline::Solution>& solutions,
                       std::optional<gl::ReadMode> mode)
    : gl(context),
      framebuffer(gl, scene.film.width, scene.film.height, scene.look.samples,
                  mode.value_or(gl::best_read_mode(gl))),
      typeface(canvas::load_typeface(scene.overlay.font)) {
  const Layout layout = compute_layout(scene);
  const auto add = [&]<typename View>(std::in_place_type_t<View>, std::size_t solution,
                                      const Layout::Pane& pane) {
    auto view = std::make_unique<View>(gl, framebuffer, scene, solutions, solution, pane);
    if (elements.empty()) first = view.get();
    elements.push_back(std::move(view));
  };
  for (std::size_t i = 0; i < layout.panes.size(); ++i) {
    add(std::in_place_type<BodyView>, i, layout.panes[i]);
  }
  if (layout.momentum) add(std::in_place_type<MomentumView>, 0, *layout.momentum);
  if (layout.poinsot) add(std::in_place_type<PoinsotView>, 0, *layout.poinsot);
  const OverlayColors& colors = style_of(scene.look.theme).overlay;
  std::vector<image::Area> taken;  // areas that labels avoid
  if (layout.components) {
    elements.push_back(
        std::make_unique<ComponentPanel>(scene, solutions, layout, typeface, colors));
    taken.push_back(*layout.components);
  }
  if (layout.curve) {
    elements.push_back(std::make_unique<CurvePanel>(scene, solutions, layout, typeface, colors));
    taken.push_back(*layout.curve);
  }
  if (layout.tilt) {
    elements.push_back(std::make_unique<TiltPanel>(scene, solutions, layout, typeface, colors));
    taken.push_back(*layout.tilt);
  }
  if (layout.moments) {
    elements.push_back(std::make_unique<MomentsPanel>(scene, solutions, layout, typeface, colors));
    taken.push_back(*layout.moments);
  }
  if (layout.forces) {
    elements.push_back(std::make_unique<ForceLegend>(
        scene, layout,
        TextStyle{typeface, colors, layout.text, layout.compact, halo_for(scene.look)}));
    taken.push_back(*layout.forces);
  }
  auto hud = std::make_unique<Hud>(scene, solutions, layout, typeface, colors);
  std::ranges::copy(hud->extents(), std::back_inserter(taken));
  elements.push_back(std::move(hud));
  label_painter.emplace(typeface.regular, layout.text.readout, colors.panel,
                        image::Area{0, 0, scene.film.width, scene.film.height}, taken);
  image::Image background = empty_picture(scene);
  for (const auto& element : elements) {
    for (const Layer& layer : element->static_layers()) composite_over(background, layer);
  }
  blank.emplace(std::move(background));
}

Renderer::Renderer(gl::Context& context, const scene::Scene& scene,
                   const std::vector<timeline::Solution>& solutions,
                   std::optional<gl::ReadMode> mode)
    : parts_(std::make_unique<Parts>(context, scene, solutions, mode)) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

PendingFrame Renderer::begin(const timeline::FrameState& state) {
  Composition composition(parts_->blank->acquire());
  std::vector<Label> labels;
  for (const auto& element : parts_->elements) {
    for (PendingLayer& layer : element->draw(state)) composition.add(std::move(layer));
    std::ranges::move(element->labels(state), std::back_inserter(labels));
  }
  for (Layer& layer : parts_->label_painter->paint(labels)) {
    composition.add(ready(std::move(layer)));
  }
  return std::async(std::launch::deferred, [composition = std::move(composition)]() mutable {
    return composition.finish();
  });
}

void Renderer::reuse(image::Frame frame) noexcept { parts_->blank->give_back(std::move(frame)); }

std::size_t Renderer::frames_ahead() const {
  return parts_->framebuffer.read_mode() == gl::ReadMode::buffered ? 1 : 0;
}

const image::Image& Renderer::static_background() const {
  return parts_->blank->static_background();
}
std::string Renderer::description() const { return gl::renderer_string(parts_->gl); }
std::string Renderer::typeface_digest() const { return canvas::typeface_digest(parts_->typeface); }
Camera Renderer::camera(const timeline::FrameState& state) const {
  return parts_->first->camera_in_space(state);
}

}  // namespace twrench::render
