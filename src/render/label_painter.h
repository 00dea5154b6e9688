#pragma once

#include <vector>

#include "canvas/canvas.h"
#include "render/label.h"
#include "render/layer.h"

namespace twrench {

/// Writes labels beside what they name or, where words or another label already are, as near by as
/// it can.
class LabelPainter {
 public:
  /// `size`: px per em; `halo`: what lies around each letter, so that it is legible on anything;
  /// `pane`: labels stay inside; `taken`: they do not go there. The font outlives the painter.
  LabelPainter(const Font& font, double size, const Color& halo, const Area& pane,
               const std::vector<Area>& taken);

  /// The first ones have the better right to their place.
  std::vector<Layer> paint(const std::vector<Label>& labels) const;

 private:
  struct Box {
    double x, y, width, height;
  };

  Box placed(Box box, const std::vector<Box>& taken) const;

  const Font& font_;
  double size_;
  Color halo_;
  Area pane_;
  std::vector<Box> taken_;
};

}  // namespace twrench
