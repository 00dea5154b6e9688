#include "render/renderer.h"

#include <algorithm>
#include <functional>
#include <future>
#include <iterator>
#include <optional>

#include "canvas/font.h"
#include "gl/framebuffer.h"
#include "render/blank_frames.h"
#include "render/compose/element.h"
#include "render/compose/label_painter.h"
#include "render/compose/layout.h"
#include "render/hud/caption.h"
#include "render/hud/component_panel.h"
#include "render/hud/curve_panel.h"
#include "render/hud/force_legend.h"
#include "render/hud/hud.h"
#include "render/hud/moments_panel.h"
#include "render/hud/tilt_panel.h"
#include "render/hud/torque_readouts.h"
#include "render/look/background.h"
#include "render/look/emphasis.h"
#include "render/look/theme.h"
#include "render/views/body_view.h"
#include "render/views/momentum_view.h"
#include "render/views/poinsot_view.h"

namespace twrench::render {
namespace {

image::Image empty_picture(const scene::Scene& scene) {
  if (scene.look.transparent) return {scene.film.width, scene.film.height, 4};
  return background(scene.look, scene.film.width, scene.film.height,
                    scene.camera.frame == scene::Frame::space);
}

PendingLayer dimmed(PendingLayer pending) {
  return std::async(std::launch::deferred, [pending = std::move(pending)]() mutable {
    AnyLayer layer = pending.get();
    std::visit([](auto& any) { scale_opacity(any, dimmed_opacity); }, layer);
    return layer;
  });
}

}  // namespace

/// What a frame is composited of.
struct Renderer::Ingredients {
  timeline::FrameState state;
  std::optional<image::Image> background;  ///< Seen through another camera than the view's own.
  std::vector<PendingLayer> views;
  std::vector<Label> labels;
};

struct Renderer::Parts {
  Parts(gl::Context& context, const scene::Scene& scene,
        const std::vector<timeline::Solution>& solutions, std::optional<gl::ReadMode> mode);

  std::shared_future<image::Image> empty;  // without any element; made while OpenGL gets ready
  gl::Functions gl;
  gl::Framebuffer framebuffer;
  canvas::Typeface typeface;
  /// A view or an element, and whether what the scene stresses lets it step back.
  template <typename Any>
  struct Shown {
    std::unique_ptr<Any> drawn;
    bool is_dimmed = false;
  };
  std::vector<Shown<SpaceView>> views;        // in compositing order
  std::vector<Shown<Element>> elements;       // over the views
  std::optional<LabelPainter> label_painter;  // over both
  std::vector<image::Area> taken;             // areas that labels avoid
  std::optional<BlankFrames> blank;

  template <typename View>
  void add_view(const scene::Scene& scene, const std::vector<timeline::Solution>& solutions,
                std::size_t solution, const Layout::Pane& pane, bool is_dimmed);
  void add_panels(const scene::Scene& scene, const std::vector<timeline::Solution>& solutions,
                  const Layout& layout);
  /// The static background, seen through the first view's present camera.
  image::Image background() const;
  /// A frame that shows `other_background`, or the blank one.
  image::Frame blank_frame(std::optional<image::Image> other_background);
  image::Frame composited(Ingredients& drawn);
};

Renderer::Parts::Parts(gl::Context& context, const scene::Scene& scene,
                       const std::vector<timeline::Solution>& solutions,
                       std::optional<gl::ReadMode> mode)
    : empty(std::async(empty_picture, std::cref(scene))),
      gl(context),
      framebuffer(gl, scene.film.width, scene.film.height, scene.look.samples,
                  mode.value_or(gl::best_read_mode(gl))),
      typeface(canvas::load_typeface(scene.overlay.font)) {
  const Layout layout = compute_layout(scene);
  for (std::size_t i = 0; i < layout.panes.size(); ++i) {
    add_view<BodyView>(scene, solutions, i, layout.panes[i], false);
  }
  const auto is_dim = [&](scene::Feature feature) { return is_dimmed(scene.overlay, feature); };
  const bool insets = scene.overlay.view == scene::View::wrench;
  if (layout.momentum) {
    add_view<MomentumView>(scene, solutions, 0, *layout.momentum,
                           insets && is_dim(scene::Feature::sphere));
  }
  if (layout.poinsot) {
    add_view<PoinsotView>(scene, solutions, 0, *layout.poinsot,
                          insets && is_dim(scene::Feature::poinsot));
  }
  add_panels(scene, solutions, layout);
  label_painter.emplace(typeface.regular, layout.text.readout,
                        style_of(scene.look.theme).overlay.panel,
                        image::Area{0, 0, scene.film.width, scene.film.height}, taken);
  blank.emplace(background());
}

/// A view of one motion.
template <typename View>
void Renderer::Parts::add_view(const scene::Scene& scene,
                               const std::vector<timeline::Solution>& solutions,
                               std::size_t solution, const Layout::Pane& pane, bool is_dimmed) {
  views.push_back(
      {std::make_unique<View>(gl, framebuffer, scene, solutions, solution, pane), is_dimmed});
}

/// Adds curves, figures and text.
void Renderer::Parts::add_panels(const scene::Scene& scene,
                                 const std::vector<timeline::Solution>& solutions,
                                 const Layout& layout) {
  const OverlayColors& colors = style_of(scene.look.theme).overlay;
  const auto add = [&](std::unique_ptr<Element> element, scene::Feature feature) {
    elements.push_back({std::move(element), is_dimmed(scene.overlay, feature)});
  };
  const auto add_plot = [&]<typename Panel>(std::in_place_type_t<Panel>,
                                            const std::optional<image::Area>& area,
                                            scene::Feature feature) {
    if (!area) return;
    add(std::make_unique<Panel>(scene, solutions, layout, typeface, colors), feature);
    taken.push_back(*area);
  };
  using enum scene::Feature;
  add_plot(std::in_place_type<ComponentPanel>, layout.components, components);
  add_plot(std::in_place_type<CurvePanel>, layout.curve, curve);
  add_plot(std::in_place_type<TiltPanel>, layout.tilt, tilt);
  add_plot(std::in_place_type<MomentsPanel>, layout.moments, moments);
  const TextStyle style{typeface, colors, layout.text, layout.compact, needs_panels(scene.look)};
  if (layout.forces) {
    add(std::make_unique<ForceLegend>(scene, layout, style), forces);
    taken.push_back(*layout.forces);
  }
  if (layout.torques) {
    add(std::make_unique<TorqueReadouts>(scene, solutions, layout, style), forces);
    taken.push_back(*layout.torques);
  }
  auto text = std::make_unique<Hud>(scene, solutions, layout, typeface, colors);
  std::ranges::copy(text->extents(), std::back_inserter(taken));
  add(std::move(text), hud);
  if (layout.caption) {
    elements.push_back(
        {std::make_unique<Caption>(*scene.caption, *layout.caption, typeface, colors)});
    taken.push_back(layout.caption->area);
  }
}

image::Image Renderer::Parts::background() const {
  image::Image picture = empty.get();
  for (const auto& [view, is_dimmed] : views) {
    for (Layer& layer : view->static_layers()) {
      if (is_dimmed) scale_opacity(layer, dimmed_opacity);
      composite_over(picture, layer);
    }
  }
  return picture;
}

image::Frame Renderer::Parts::blank_frame(std::optional<image::Image> other_background) {
  image::Frame frame = blank->acquire();
  if (!other_background) return frame;
  frame.image = std::move(*other_background);
  frame.damage.assign(1, {0, 0, frame.image.width, frame.image.height});
  return frame;
}

image::Frame Renderer::Parts::composited(Ingredients& drawn) {
  image::Frame frame = blank_frame(std::move(drawn.background));
  const auto add = [&](const auto& layer) {
    std::ranges::move(composite_over(frame.image, layer), std::back_inserter(frame.damage));
  };
  for (PendingLayer& pending : drawn.views) std::visit(add, pending.get());
  for (const auto& [element, is_dimmed] : elements) {
    for (Layer& layer : element->draw(drawn.state)) {
      if (is_dimmed) scale_opacity(layer, dimmed_opacity);
      add(layer);
    }
  }
  std::ranges::for_each(label_painter->paint(drawn.labels), add);
  if (frame.image.channels == 4) {
    unpremultiply(frame.image, {0, 0, frame.image.width, frame.image.height});
  }
  return frame;
}

Renderer::Renderer(gl::Context& context, const scene::Scene& scene,
                   const std::vector<timeline::Solution>& solutions,
                   std::optional<gl::ReadMode> mode)
    : parts_(std::make_unique<Parts>(context, scene, solutions, mode)) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

image::PendingFrame Renderer::begin(timeline::FrameState state,
                                    const std::optional<Camera>& camera) {
  auto drawn = std::make_shared<Ingredients>();
  SpaceView& first = *parts_->views.front().drawn;
  first.look_through(camera);
  if (camera) drawn->background = parts_->background();
  for (const auto& [view, is_dimmed] : parts_->views) {
    for (PendingLayer& layer : view->draw(state)) {
      drawn->views.push_back(is_dimmed ? dimmed(std::move(layer)) : std::move(layer));
    }
    std::ranges::move(view->labels(state), std::back_inserter(drawn->labels));
  }
  first.look_through({});
  drawn->state = std::move(state);
  const auto transfer = [drawn, mode = parts_->framebuffer.read_mode()] {
    if (mode == gl::ReadMode::buffered) std::ranges::for_each(drawn->views, complete);
  };
  const auto composition = [drawn, parts = parts_.get()] { return parts->composited(*drawn); };
  return {std::async(std::launch::deferred, transfer),
          std::async(std::launch::deferred, composition)};
}

bool Renderer::drew(const image::Frame& frame) const noexcept {
  return frame.background == parts_->blank->bands();
}

void Renderer::reuse(image::Frame frame) noexcept { parts_->blank->give_back(std::move(frame)); }

std::size_t Renderer::frames_ahead() const {
  return parts_->framebuffer.read_mode() == gl::ReadMode::buffered ? 1 : 0;
}

const image::Image& Renderer::static_background() const {
  return parts_->blank->static_background();
}
Camera Renderer::camera(const timeline::FrameState& state) const {
  return parts_->views.front().drawn->camera_in_space(state);
}

}  // namespace twrench::render
