#pragma once

#include <array>
#include <optional>
#include <vector>

#include "canvas/canvas.h"
#include "render/compose/element.h"
#include "render/compose/layout.h"
#include "render/look/theme.h"

namespace twrench::render {

/// The nine components of X against time: the past in full strength, the future faint, with a
/// cursor between them. In a comparison, each plot shows the curves of all methods.
class ComponentPanel : public Element {
 public:
  ComponentPanel(const scene::Scene& scene, const std::vector<timeline::Solution>& solutions,
                 const Layout& layout, const canvas::Typeface& typeface,
                 const OverlayColors& colors);

  std::vector<PendingLayer> draw(const timeline::FrameState& state) override;

 private:
  /// One of the nine plots.
  struct Plot {
    int row, column;
    image::Area area;

    double x(double share) const { return area.x + share * area.width; }
    double y(double value) const;
  };

  void place_plots(const image::Area& area, double label_size);
  void draw_frames(canvas::Canvas& canvas, const Layout& layout,
                   const canvas::Typeface& typeface) const;
  void draw_curves(canvas::Canvas& canvas, const timeline::Solution& solution, std::size_t index,
                   double opacity) const;
  scene::Color ink(const Plot& plot, std::size_t solution) const;

  const OverlayColors& colors_;
  double duration_;
  std::size_t solutions_;
  double thickness_;  ///< Thickness of a curve in px.
  std::vector<Plot> plots_;
  Layer future_;
  Layer past_;
};

}  // namespace twrench::render
