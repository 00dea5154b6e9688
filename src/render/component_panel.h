#pragma once

#include <array>
#include <optional>
#include <vector>

#include "canvas/canvas.h"
#include "render/element.h"
#include "render/layout.h"
#include "render/theme.h"

namespace twrench {

/// The nine components of X against time: the past in full strength, the future faint, with a
/// cursor between them. In a comparison, each plot shows the curves of all methods.
class ComponentPanel : public Element {
 public:
  ComponentPanel(const Scene& scene, const std::vector<Take>& takes, const Layout& layout,
                 const Typeface& typeface, const OverlayColors& colors);

  std::vector<PendingLayer> draw(const Moment& moment) override;

 private:
  /// One of the nine plots.
  struct Plot {
    int row, column;
    Area area;

    double x(double share) const { return area.x + share * area.width; }
    double y(double value) const;
  };

  void place_plots(const Area& area, double label_size);
  void draw_frames(Canvas& canvas, const Layout& layout, const Typeface& typeface) const;
  void draw_curves(Canvas& canvas, const Take& take, std::size_t index, double opacity) const;
  Color ink(const Plot& plot, std::size_t take) const;

  const OverlayColors& colors_;
  double duration_;
  std::size_t takes_;
  double thickness_;  ///< Thickness of a curve in px.
  std::vector<Plot> plots_;
  Layer future_;
  Layer past_;
};

}  // namespace twrench
