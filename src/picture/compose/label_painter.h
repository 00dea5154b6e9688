#pragma once

#include <vector>

#include "canvas/canvas.h"
#include "picture/compose/label.h"
#include "picture/compose/layer.h"

namespace twrench::picture {

/// Draws labels next to the objects that they name. If text, another label or another named object
/// is in the way, a label is moved as little as possible; a thin line leads to a label that was
/// moved far. Labels move continuously if the objects do.
class LabelPainter {
 public:
  /// `size` is in px per em; `halo` is the colour around each letter that keeps it legible on any
  /// background; labels stay inside `pane` and avoid the areas `taken`. The font must outlive the
  /// painter.
  LabelPainter(const canvas::Font& font, double size, const Color& halo, const image::Area& pane,
               const std::vector<image::Area>& taken);

  /// Draws the labels; earlier ones have priority.
  std::vector<Layer> paint(const std::vector<Label>& labels) const;

 private:
  struct Box {
    double x, y, width, height;
    Eigen::Vector2d middle() const { return {x + width / 2, y + height / 2}; }
  };

  Box beside_objects(Box box, const std::vector<Label>& labels, const Label& own) const;
  Box placed(Box box, const std::vector<Box>& taken) const;
  Layer painted(const Label& label, const canvas::Line& line, const Box& box, double moved) const;
  void lead_to(const Box& box, const Label& label, double opacity, canvas::Canvas& canvas) const;

  const canvas::Font& font_;
  double size_;
  Color halo_;
  image::Area pane_;
  std::vector<Box> taken_;
};

}  // namespace twrench::picture
