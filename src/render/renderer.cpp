#include "render/renderer.h"

#include <algorithm>
#include <chrono>
#include <deque>
#include <iterator>
#include <mutex>
#include <optional>

#include "gl/framebuffer.h"
#include "render/background.h"
#include "render/component_panel.h"
#include "render/element.h"
#include "render/hud.h"
#include "render/label_painter.h"
#include "render/layout.h"
#include "render/momentum_view.h"
#include "render/poinsot_view.h"
#include "render/theme.h"
#include "render/wrench_view.h"

namespace twrench {
namespace {

using namespace std::chrono_literals;

Image empty_picture(const Scene& scene) {
  if (scene.look.transparent) return {scene.film.width, scene.film.height, 4};
  return background(scene.look, scene.film.width, scene.film.height);
}

/// Copies `still` to `image` within `area`.
void restore(Image& image, const Image& still, const Area& area) {
  const auto channels = static_cast<std::size_t>(still.channels);
  for (int row = area.y; row < area.y + area.height; ++row) {
    const auto first =
        static_cast<std::ptrdiff_t>(static_cast<std::size_t>(row) * still.row_bytes() +
                                    static_cast<std::size_t>(area.x) * channels);
    std::copy_n(still.pixels.begin() + first, static_cast<std::size_t>(area.width) * channels,
                image.pixels.begin() + first);
  }
}

/// Frames to draw into, and frames that were drawn and are no longer needed.
class BlankFrames {
 public:
  explicit BlankFrames(Image still) : still_(std::move(still)) { used_.reserve(most); }

  const Image& still() const { return still_; }

  Frame take() {
    Frame frame;
    {
      const std::lock_guard lock(mutex_);
      if (used_.empty()) return {still_, {}};
      frame = std::move(used_.back());
      used_.pop_back();
    }
    for (const Area& area : frame.changed) restore(frame.image, still_, area);
    frame.changed.clear();
    return frame;
  }

  void give_back(Frame frame) noexcept {
    // A frame's alpha is unpremultiplied, the static background's is not.
    if (still_.channels == 4) return;
    const std::lock_guard lock(mutex_);
    if (used_.size() < most) used_.push_back(std::move(frame));
  }

 private:
  static constexpr std::size_t most = 16;  // as many as are in progress at once

  Image still_;  // premultiplied if RGBA
  std::mutex mutex_;
  std::vector<Frame> used_;
};

/// Composites layers in order: each as soon as it and all below it are ready.
class Composition {
 public:
  explicit Composition(Frame blank) : frame_(std::move(blank)) {}

  void add(PendingLayer layer) {
    layers_.push_back(std::move(layer));
    while (!layers_.empty() && layers_.front().wait_for(0s) == std::future_status::ready) {
      lay_first();
    }
  }

  /// Returns the frame when all layers are composited.
  Frame take() {
    while (!layers_.empty()) lay_first();
    if (frame_.image.channels == 4) {
      make_straight(frame_.image, {0, 0, frame_.image.width, frame_.image.height});
    }
    return std::move(frame_);
  }

 private:
  void lay_first() {
    const Layer layer = layers_.front().get();
    layers_.pop_front();
    frame_.changed.push_back(lay_over(frame_.image, layer));
  }

  Frame frame_;
  std::deque<PendingLayer> layers_;
};

}  // namespace

struct Renderer::Parts {
  Parts(gl::Context& context, const Scene& scene, const std::vector<Take>& takes,
        std::optional<gl::ReadMode> mode);

  gl::Functions gl;
  gl::Framebuffer framebuffer;
  Typeface typeface;
  std::vector<std::unique_ptr<Element>> elements;  // in compositing order
  std::optional<LabelPainter> label_painter;
  const SpaceView* first = nullptr;
  std::optional<BlankFrames> blank;
};

Renderer::Parts::Parts(gl::Context& context, const Scene& scene, const std::vector<Take>& takes,
                       std::optional<gl::ReadMode> mode)
    : gl(context),
      framebuffer(gl, scene.film.width, scene.film.height, scene.look.samples,
                  mode.value_or(gl::best_read_mode(gl))),
      typeface(load_typeface(scene.overlay.font)) {
  const Layout layout = layout_of(scene);
  const auto add = [&]<typename View>(std::in_place_type_t<View>, std::size_t take,
                                      const Layout::Pane& pane) {
    auto view = std::make_unique<View>(gl, framebuffer, scene, takes, take, pane);
    if (elements.empty()) first = view.get();
    elements.push_back(std::move(view));
  };
  for (std::size_t i = 0; i < layout.panes.size(); ++i) {
    add(std::in_place_type<WrenchView>, i, layout.panes[i]);
  }
  if (layout.momentum) add(std::in_place_type<MomentumView>, 0, *layout.momentum);
  if (layout.poinsot) add(std::in_place_type<PoinsotView>, 0, *layout.poinsot);
  const OverlayColors& colors = style_of(scene.look.theme).overlay;
  std::vector<Area> taken;  // areas that labels avoid
  if (layout.components) {
    elements.push_back(std::make_unique<ComponentPanel>(scene, takes, layout, typeface, colors));
    taken.push_back(*layout.components);
  }
  auto hud = std::make_unique<Hud>(scene, takes, layout, typeface, colors);
  std::ranges::copy(hud->extents(), std::back_inserter(taken));
  elements.push_back(std::move(hud));
  label_painter.emplace(typeface.regular, layout.text.figure, colors.panel,
                        Area{0, 0, scene.film.width, scene.film.height}, taken);
  Image still = empty_picture(scene);
  for (const auto& element : elements) {
    for (const Layer& layer : element->still()) lay_over(still, layer);
  }
  blank.emplace(std::move(still));
}

Renderer::Renderer(gl::Context& context, const Scene& scene, const std::vector<Take>& takes,
                   std::optional<gl::ReadMode> mode)
    : parts_(std::make_unique<Parts>(context, scene, takes, mode)) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

PendingFrame Renderer::begin(const Moment& moment) {
  Composition composition(parts_->blank->take());
  std::vector<Label> labels;
  for (const auto& element : parts_->elements) {
    for (PendingLayer& layer : element->draw(moment)) composition.add(std::move(layer));
    std::ranges::move(element->labels(moment), std::back_inserter(labels));
  }
  for (Layer& layer : parts_->label_painter->paint(labels)) {
    composition.add(ready(std::move(layer)));
  }
  return std::async(std::launch::deferred, [composition = std::move(composition)]() mutable {
    return composition.take();
  });
}

void Renderer::reuse(Frame frame) noexcept { parts_->blank->give_back(std::move(frame)); }

std::size_t Renderer::frames_ahead() const {
  return parts_->framebuffer.read_mode() == gl::ReadMode::buffered ? 1 : 0;
}

const Image& Renderer::still() const { return parts_->blank->still(); }
std::string Renderer::description() const { return gl::renderer_string(parts_->gl); }
Camera Renderer::camera(double film_time) const { return parts_->first->camera(film_time); }

}  // namespace twrench
