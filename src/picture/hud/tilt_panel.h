#pragma once

#include <twrench/motion/stability.h>

#include <vector>

#include "canvas/canvas.h"
#include "picture/compose/element.h"
#include "picture/compose/layout.h"
#include "picture/hud/angle_scale.h"
#include "picture/look/theme.h"

namespace twrench::picture {

/// The tilt of the body against L (motion::Tilt) against time on a logarithmic scale, drawn as the
/// motion goes on: the curve ends with a dot at the present, and ticks on the time axis mark each
/// doubling so far or, if these are too dense, each factor of ten. If the axis is unstable, a
/// dashed straight line is the growth that the linearised equations predict; a caption states the
/// prediction.
class TiltPanel : public Element {
 public:
  /// Uses layout.tilt. Shows the first solution.
  TiltPanel(const scene::Scene& scene, const std::vector<timeline::Solution>& solutions,
            const Layout& layout, const canvas::Typeface& typeface, const OverlayColors& colors);

  std::vector<Layer> draw(const timeline::FrameState& state) override;

  /// Returns the position in px at which a tilt in rad at a time in s is drawn.
  canvas::Canvas::Point place(double time, double tilt) const;

  /// Growth by a factor since the start of the motion or the previous mark.
  struct Mark {
    double time;  ///< In s.
    double tilt;  ///< In rad.
  };
  /// Returns the marks of the whole motion.
  const std::vector<Mark>& marks() const { return marks_; }

 private:
  void place_plot(const image::Area& area);
  void draw_prediction(canvas::Canvas& canvas, double opacity) const;
  std::vector<Mark> marks_of(const std::vector<motion::Sample>& whole, double factor) const;
  bool are_dense(const std::vector<Mark>& marks) const;
  void draw_marks(canvas::Canvas& canvas, double until) const;

  const OverlayColors& colors_;
  const canvas::Typeface& typeface_;
  motion::Tilt tilt_;
  double duration_;    ///< Duration of the motion in s.
  double size_;        ///< Size of the text in px.
  double value_size_;  ///< Size of the current value in px.
  double thickness_;   ///< Thickness of the curve in px.
  AngleScale scale_;
  canvas::Canvas::Point value_;  ///< Position of the text of the current value.
  double factor_ = 2;            ///< The growth from one mark to the next.
  std::vector<Mark> marks_;
  Layer future_;
  Layer past_;
};

}  // namespace twrench::picture
