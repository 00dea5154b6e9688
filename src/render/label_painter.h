#pragma once

#include <vector>

#include "canvas/canvas.h"
#include "render/label.h"
#include "render/layer.h"

namespace twrench {

/// Draws labels next to what they name, moved as little as possible where text or another label is
/// in the way.
class LabelPainter {
 public:
  /// `size` is in px per em; `halo` is the colour around each letter that keeps it legible on any
  /// background; labels stay inside `pane` and avoid the areas `taken`. The font must outlive the
  /// painter.
  LabelPainter(const Font& font, double size, const Color& halo, const Area& pane,
               const std::vector<Area>& taken);

  /// Draws the labels; earlier ones have priority.
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
