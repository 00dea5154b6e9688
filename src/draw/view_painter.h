#pragma once

#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include "draw/exposure.h"
#include "draw/soft_layer.h"
#include "gl/framebuffer.h"
#include "image/frame.h"
#include "picture/compose/layer.h"
#include "picture/views/view.h"

namespace twrench::draw {

/// A layer of pixels or one without sharp detail.
using AnyLayer = std::variant<picture::Layer, SoftLayer>;

using PendingLayer = image::Pending<AnyLayer>;

/// Returns the layer that `make` makes of the image of `pixels`, a gl::Readback or a
/// PendingExposure.
template <typename Pixels, typename Make>
PendingLayer pending_layer(Pixels pixels, Make make) {
  const auto shared = std::make_shared<Pixels>(std::move(pixels));
  return {[shared] { shared->fetch(); },
          [shared, make = std::move(make)] { return AnyLayer(make(shared->finish())); }};
}

/// Returns the pixels unchanged as a layer with its top left corner in that of `area`.
template <typename Pixels>
PendingLayer layer_at(const image::Area& area, Pixels pixels) {
  return pending_layer(std::move(pixels), [x = area.x, y = area.y](image::Image image) {
    return picture::Layer{std::move(image), x, y};
  });
}

/// Draws the contents of a view, on its renderer's thread.
class ViewPainter {
 public:
  virtual ~ViewPainter() = default;

  /// Returns the contents that View::add_still() added, as layers in compositing order.
  virtual std::vector<picture::Layer> draw_still(const picture::ViewContents& contents) = 0;

  /// Returns the contents as layers in compositing order. They lie entirely inside the picture and
  /// are as small as their contents. Painters may draw more before a layer is completed; the
  /// painter outlives its layers.
  virtual std::vector<PendingLayer> draw(const picture::ViewContents& contents) = 0;
};

/// Returns an area in OpenGL's coordinates, which count rows from the bottom of a picture of that
/// height.
inline gl::Rectangle gl_rectangle(const image::Area& area, int picture_height) {
  return {area.x, picture_height - area.y - area.height, area.width, area.height};
}

}  // namespace twrench::draw
