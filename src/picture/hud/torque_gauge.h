#pragma once

#include <string>
#include <vector>

#include "canvas/canvas.h"
#include "picture/compose/element.h"
#include "picture/compose/layout.h"
#include "picture/look/theme.h"
#include "timeline/tilting_torque.h"

namespace twrench::picture {

/// The tug-of-war between the torques that tilt the body back, at the left, and those that tilt it
/// further, at the right: a bar from the middle for each, its value above the names of the groups
/// of parts, and a marker at their sum. The scale and the number of decimals are those of the whole
/// film.
class TorqueGauge : public Element {
 public:
  /// Uses layout.torques. Shows the first solution.
  TorqueGauge(const scene::Scene& scene, const std::vector<timeline::Solution>& solutions,
              const Layout& layout, const canvas::Typeface& typeface, const OverlayColors& colors);

  std::vector<Layer> draw(const timeline::FrameState& state) override;

  /// Returns the area of the whole bar.
  const image::Area& bar() const { return bar_; }

  /// Returns the position in px, from the left edge of the picture, of a torque in g cm^2/s^2.
  double place(double torque) const;

  /// Returns a torque as the gauge states it, without its unit.
  std::string text(double torque) const;

  /// Returns the width in em that the names of the groups of a side have. Longer ones are
  /// truncated.
  double name_width() const { return name_width_; }

 private:
  void draw_side(canvas::Canvas& canvas, double torque, const std::string& names,
                 canvas::Canvas::Align align) const;

  const OverlayColors& colors_;
  const canvas::Typeface& typeface_;
  timeline::TiltingTorque torque_;
  double size_;       ///< Size of the text in px.
  double strongest_;  ///< The largest torque of the film; 0 if there is none.
  int exponent_ = 0;  ///< Values are multiples of this power of ten.
  int decimals_ = 0;
  image::Area bar_;
  double value_line_;  ///< Baseline of the values.
  double name_width_;
  Layer ground_;
};

}  // namespace twrench::picture
