#include "draw/renderer.h"

#include <algorithm>
#include <functional>
#include <future>
#include <iterator>
#include <optional>

#include "canvas/font.h"
#include "draw/body_painter.h"
#include "draw/draw_list_pass.h"
#include "gl/framebuffer.h"
#include "picture/compose/element.h"
#include "picture/compose/label_painter.h"
#include "picture/compose/layout.h"
#include "picture/hud/angle_panel.h"
#include "picture/hud/caption.h"
#include "picture/hud/component_panel.h"
#include "picture/hud/curve_panel.h"
#include "picture/hud/force_legend.h"
#include "picture/hud/hud.h"
#include "picture/hud/moments_panel.h"
#include "picture/hud/tilt_panel.h"
#include "picture/hud/torque_gauge.h"
#include "picture/look/background.h"
#include "picture/look/emphasis.h"
#include "picture/look/theme.h"
#include "picture/views/body_view.h"
#include "picture/views/inset_views.h"

namespace twrench::draw {
namespace {

using picture::Camera;
using picture::Element;
using picture::Layer;
using picture::Layout;
using picture::View;
using picture::ViewContents;

/// The stars around a body belong to its view.
image::Image empty_picture(const scene::Scene& scene) {
  if (scene.look.transparent) return {scene.film.width, scene.film.height, 4};
  const bool shows_body = scene::inset_index(scene.overlay.view) == scene::insets.size();
  return picture::background(scene.look, scene.film.width, scene.film.height, !shows_body);
}

}  // namespace

/// The parts of which a frame is composited.
struct Renderer::Ingredients {
  timeline::FrameState state;
  std::optional<image::Image> background;  ///< Set unless the view's own camera is used.
  struct DrawnLayer {
    PendingLayer layer;
    bool is_dimmed;
  };
  std::vector<DrawnLayer> layers;  ///< The views' layers, in compositing order.
  std::vector<picture::Label> labels;
};

struct Renderer::Parts {
  Parts(gl::Context& context, const scene::Scene& scene,
        const std::vector<timeline::Solution>& solutions, std::optional<gl::ReadMode> mode);

  std::shared_future<image::Image> empty;  // without any element; drawn while OpenGL initialises
  gl::Functions gl;
  gl::Framebuffer framebuffer;
  canvas::Typeface typeface;
  /// A view, and whether it is dimmed because the scene stresses other features.
  struct ShownView {
    std::unique_ptr<View> view;
    std::unique_ptr<ViewPainter> painter;
    bool is_dimmed;
    ViewContents contents;  ///< Contents in the last frame.
  };
  struct ShownElement {
    std::unique_ptr<Element> element;
    bool is_dimmed;
  };
  std::vector<ShownView> views;        // in compositing order
  std::vector<ShownElement> elements;  // over the views
  std::optional<picture::Caption> caption;
  std::optional<picture::LabelPainter> label_painter;  // over both
  std::vector<image::Area> taken;                      // areas that labels avoid
  bool shows_body = false;
  std::shared_ptr<const image::Image> still;  // the static background

  void add_bodies(const scene::Scene& scene, const std::vector<timeline::Solution>& solutions,
                  const Layout& layout);
  void add_insets(const scene::Scene& scene, const std::vector<timeline::Solution>& solutions,
                  const Layout& layout);
  void add_panels(const scene::Scene& scene, const std::vector<timeline::Solution>& solutions,
                  const Layout& layout);
  /// The static background. `camera`, if given, replaces the first view's own.
  image::Image background(const std::optional<Camera>& camera);
  Ingredients draw(timeline::FrameState state, const std::optional<Camera>& camera);
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
  const Layout layout = picture::compute_layout(scene);
  add_bodies(scene, solutions, layout);
  add_insets(scene, solutions, layout);
  add_panels(scene, solutions, layout);
  label_painter.emplace(typeface.regular, layout.text.readout,
                        picture::style_of(scene.look.theme).overlay.panel,
                        image::Area{0, 0, scene.film.width, scene.film.height}, taken);
  still = std::make_shared<const image::Image>(background({}));
}

/// Adds a view of the body for each motion.
void Renderer::Parts::add_bodies(const scene::Scene& scene,
                                 const std::vector<timeline::Solution>& solutions,
                                 const Layout& layout) {
  shows_body = !layout.panes.empty();
  const std::vector<body::Part> parts = scene::visible_parts(scene.body);
  for (std::size_t i = 0; i < layout.panes.size(); ++i) {
    auto view = std::make_unique<picture::BodyView>(scene, solutions, i, layout.panes[i]);
    auto painter =
        std::make_unique<BodyPainter>(gl, framebuffer, *view, parts, scene.look.samples > 1);
    views.push_back({std::move(view), std::move(painter), false, {}});
  }
}

/// Adds the other views, which show the first motion. They can be dimmed beside a body.
void Renderer::Parts::add_insets(const scene::Scene& scene,
                                 const std::vector<timeline::Solution>& solutions,
                                 const Layout& layout) {
  for (std::size_t i = 0; i < scene::insets.size(); ++i) {
    const std::optional<Layout::Pane>& pane = layout.insets[i];
    if (!pane) continue;
    const bool is_dimmed = scene.overlay.view == scene::View::wrench &&
                           picture::is_dimmed(scene.overlay, scene::insets[i].feature);
    views.push_back({picture::inset_views[i].make(scene, solutions, *pane),
                     std::make_unique<DrawListPainter>(gl, framebuffer, pane->area),
                     is_dimmed,
                     {}});
  }
}

/// Adds curves, figures and text.
void Renderer::Parts::add_panels(const scene::Scene& scene,
                                 const std::vector<timeline::Solution>& solutions,
                                 const Layout& layout) {
  const picture::OverlayColors& colors = picture::style_of(scene.look.theme).overlay;
  const auto add = [&](std::unique_ptr<Element> element, scene::Feature feature) {
    elements.push_back({std::move(element), picture::is_dimmed(scene.overlay, feature)});
  };
  const auto add_plot = [&]<typename Panel>(std::in_place_type_t<Panel>,
                                            const std::optional<image::Area>& area,
                                            scene::Feature feature) {
    if (!area) return;
    add(std::make_unique<Panel>(scene, solutions, layout, typeface, colors), feature);
    taken.push_back(*area);
  };
  using enum scene::Feature;
  add_plot(std::in_place_type<picture::ComponentPanel>, layout.components, components);
  add_plot(std::in_place_type<picture::CurvePanel>, layout.curve, curve);
  add_plot(std::in_place_type<picture::AnglePanel>, layout.angle, curve);
  add_plot(std::in_place_type<picture::TiltPanel>, layout.tilt, tilt);
  add_plot(std::in_place_type<picture::MomentsPanel>, layout.moments, moments);
  add_plot(std::in_place_type<picture::TorqueGauge>, layout.torques, torques);
  const picture::TextStyle style{typeface, colors, layout.text, layout.compact,
                                 picture::needs_panels(scene.look)};
  if (layout.forces) {
    add(std::make_unique<picture::ForceLegend>(scene, layout, style), forces);
    taken.push_back(*layout.forces);
  }
  auto text = std::make_unique<picture::Hud>(scene, solutions, layout, typeface, colors);
  std::ranges::copy(text->extents(), std::back_inserter(taken));
  add(std::move(text), hud);
  if (layout.caption) {
    caption.emplace(*scene.caption, *layout.caption, typeface, colors);
    taken.push_back(layout.caption->area);
  }
}

image::Image Renderer::Parts::background(const std::optional<Camera>& camera) {
  image::Image picture = empty.get();
  for (std::size_t i = 0; i < views.size(); ++i) {
    const auto& [view, painter, is_dimmed, last] = views[i];
    ViewContents contents;
    const bool moves = i == 0 && camera;
    contents.begin(moves ? *camera : view->camera(0), view->pane().area, moves);
    view->add_still(contents);
    for (Layer& layer : painter->draw_still(contents)) {
      if (is_dimmed) scale_opacity(layer, picture::dimmed_opacity);
      composite_over(picture, layer);
    }
  }
  return picture;
}

/// Draws the views. `camera`, if given, replaces the first view's own.
Renderer::Ingredients Renderer::Parts::draw(timeline::FrameState state,
                                            const std::optional<Camera>& camera) {
  Ingredients drawn;
  if (camera) drawn.background = background(camera);
  for (std::size_t i = 0; i < views.size(); ++i) {
    auto& [view, painter, is_dimmed, contents] = views[i];
    const bool moves = i == 0 && camera;
    contents.begin(moves ? *camera : view->camera_in_space(state), view->pane().area, moves);
    view->add(state, contents);
    for (PendingLayer& layer : painter->draw(contents)) {
      drawn.layers.push_back({std::move(layer), is_dimmed});
    }
    std::ranges::move(contents.labels, std::back_inserter(drawn.labels));
  }
  drawn.state = std::move(state);
  return drawn;
}

image::Frame Renderer::Parts::composited(Ingredients& drawn) {
  image::Frame frame{drawn.background ? std::move(*drawn.background) : *still, {}, true, still};
  if (drawn.background) frame.damage.assign(1, {0, 0, frame.image.width, frame.image.height});
  const auto add = [&](auto& layer, bool is_dimmed) {
    if (is_dimmed) scale_opacity(layer, picture::dimmed_opacity);
    std::ranges::move(composite_over(frame.image, layer), std::back_inserter(frame.damage));
  };
  for (Ingredients::DrawnLayer& drawn_layer : drawn.layers) {
    std::visit([&](auto&& layer) { add(layer, drawn_layer.is_dimmed); },
               drawn_layer.layer.finish());
  }
  const double opacity = drawn.state.text_opacity;
  const auto add_text = [&](std::vector<Layer> text, bool is_dimmed) {
    for (Layer& layer : text) {
      if (opacity < 1) scale_opacity(layer, opacity);
      if (opacity > 0) add(layer, is_dimmed);
    }
  };
  for (const auto& [element, is_dimmed] : elements) {
    add_text(element->draw(drawn.state), is_dimmed);
  }
  if (caption) {
    for (Layer& layer : caption->draw(drawn.state)) add(layer, false);
  }
  add_text(label_painter->paint(drawn.labels), false);
  if (frame.image.channels == 4) {
    picture::unpremultiply(frame.image, {0, 0, frame.image.width, frame.image.height});
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
  const bool has_other_camera = camera && parts_->shows_body;
  auto drawn = std::make_shared<Ingredients>(
      parts_->draw(std::move(state), has_other_camera ? camera : std::nullopt));
  return {[drawn] {
            for (auto& [layer, is_dimmed] : drawn->layers) layer.fetch();
          },
          [drawn, parts = parts_.get()] { return parts->composited(*drawn); }};
}

std::size_t Renderer::frames_ahead() const {
  return parts_->framebuffer.read_mode() == gl::ReadMode::buffered ? 1 : 0;
}

Camera Renderer::camera(const timeline::FrameState& state) const {
  return parts_->views.front().view->camera_in_space(state);
}

}  // namespace twrench::draw
