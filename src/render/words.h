#pragma once

#include <functional>
#include <string>
#include <vector>

#include "canvas/canvas.h"
#include "render/layer.h"
#include "render/layout.h"
#include "render/theme.h"
#include "timeline/timeline.h"

namespace twrench {

/// The style of a text block.
struct WordStyle {
  /// The font.
  const Typeface& typeface;
  /// Colours of text and panel.
  const OverlayColors& colors;
  /// Text sizes.
  Layout::TextSizes sizes;
  /// Captions stand beside their readouts instead of above.
  bool compact;
};

/// A readout: a changing value with its caption.
struct Reading {
  /// Caption.
  std::string caption;
  /// A text at least as wide as every value.
  std::string widest;
  std::function<std::string(const Moment&)> value;
};

/// Returns the height in px of that many rows of readouts with captions.
double height_of_figures(const Layout::TextSizes& sizes, bool compact, int rows);

/// A text block on a soft panel, which keeps it legible on any background. Everything except the
/// values of the readouts is drawn once.
class WordBlock {
 public:
  /// Uses the part of `area` that the text needs, starting at its top left.
  WordBlock(const WordStyle& style, const Area& area);

  /// Adds a line. If it is too long, it is set smaller, down to the readouts' size, and then
  /// truncated. With `curve`, a sample of the curve precedes it.
  void add_line(const std::string& text, const Font& font, double size, const Color& ink,
                const Color* curve = nullptr);

  /// Adds readouts side by side in rows or, in an upright area, stacked; omits the last ones if
  /// there is not enough room.
  void add_figures(const std::vector<Reading>& figures);

  /// Adds a readout without a caption in the top right corner; later lines leave room for it.
  void add_corner(Reading figure);

  /// Completes the block. The panel's soft edges may extend within `picture`.
  void finish(const Area& picture);

  Layer draw(const Moment& moment) const;

  /// Returns the area that the text covers.
  const Area& extent() const { return extent_; }

  /// Returns whether no text fitted.
  bool is_empty() const { return extent_.width <= 0 || extent_.height <= 0; }

 private:
  struct Text {
    Line line;
    double size;
    Canvas::Point at;
    Color ink;
  };
  struct Value {
    std::function<std::string(const Moment&)> text;
    double size;
    Canvas::Point at;
    Canvas::Align align;
  };

  void extend(double right, double bottom);
  void place(const Reading& figure, double x, double y, double caption_width);

  WordStyle style_;
  Area area_;
  Area extent_;
  double y_;  ///< Where the next line begins.
  double corner_width_ = 0;
  std::vector<Text> texts_;
  std::vector<Value> values_;
  std::vector<std::pair<Area, Color>> samples_;  ///< Samples of curves.
  Layer ground_;
};

}  // namespace twrench
