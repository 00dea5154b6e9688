#pragma once

#include <string>
#include <vector>

#include "canvas/canvas.h"
#include "picture/compose/element.h"
#include "picture/look/theme.h"

namespace twrench::picture {

/// Plots of components of X against time on a panel: the past in full strength, the future faint,
/// with a cursor between them. In a comparison, each plot shows the curves of all methods.
class PlotPanel : public Element {
 public:
  std::vector<Layer> draw(const timeline::FrameState& state) override;

 protected:
  /// The component of a body axis along a direction in space against time.
  struct Plot {
    Eigen::Vector3d direction, axis;  ///< Unit vectors.
    std::size_t color;                ///< Index into OverlayColors::curve.
    image::Area area;

    double value(const motion::Sample& sample) const { return direction.dot(sample.X * axis); }

    /// Return the position in the picture, in px, of a share of the duration and of a value.
    double x(double share) const { return area.x + share * area.width; }
    double y(double value) const;
  };

  /// `area` is that of the panel, and `thickness` that of a curve, in px.
  PlotPanel(const scene::Scene& scene, const std::vector<timeline::Solution>& solutions,
            const image::Area& area, double thickness, const OverlayColors& colors);

  /// Returns a canvas for the layer below the curves.
  canvas::Canvas ground() { return {future_.image, future_.x, future_.y}; }

  /// Draws the curves; called once, when plots and ground are complete.
  void add_curves(const std::vector<timeline::Solution>& solutions);

  /// Draws a line through each plot at each flip. With several methods, whose flips differ, the
  /// lines would clutter the plots.
  void mark_flips(const timeline::Solution& solution);

  /// Draws the zero lines.
  void mark_zeros();

  /// Returns the plot of the component of X in that row and column, counted from 0.
  static Plot component(int row, int column, const image::Area& area);

  /// Returns the name of a component of X, "x₁₁" for the first.
  static std::string name_of(const Plot& component);

  bool compares() const { return solutions_ > 1; }
  Color ink(const Plot& plot, std::size_t solution) const;

  const OverlayColors& colors_;
  double duration_;
  std::vector<Plot> plots_;

 private:
  void draw_curves(canvas::Canvas& canvas, const timeline::Solution& solution, std::size_t index,
                   double opacity) const;

  std::size_t solutions_;
  double thickness_;
  Layer future_;
  Layer past_;
};

}  // namespace twrench::picture
