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

/// What words are set in.
struct WordStyle {
  const Typeface& typeface;
  const OverlayColors& colors;
  Layout::TextSizes sizes;
  bool compact;  ///< captions go before their figures, not above them
};

/// A figure that changes, with what it is.
struct Reading {
  std::string caption;
  std::string widest;  ///< what no value of it is wider than
  std::function<std::string(const Moment&)> value;
};

/// px: of so many rows of figures, each with its caption.
double height_of_figures(const Layout::TextSizes& sizes, bool compact, int rows);

/// Words on a soft panel, which makes them legible whatever lies below. All but the figures' values
/// is drawn once.
class WordBlock {
 public:
  /// In the part of `area` that the words need, from its top left on.
  WordBlock(const WordStyle& style, const Area& area);

  /// A line of its own; one that is too long is set smaller, down to the figures' size, and then
  /// shortened. With a sample of `curve` before it.
  void add_line(const std::string& text, const Font& font, double size, const Color& ink,
                const Color* curve = nullptr);

  /// Side by side in rows or, where the area is upright, below one another: the first ones, where
  /// there is no room for all.
  void add_figures(const std::vector<Reading>& figures);

  /// In the top right corner, without a caption; lines that are added later leave it room.
  void add_corner(Reading figure);

  /// When all is added. `picture`: what the panel's soft edges may reach into.
  void finish(const Area& picture);

  Layer draw(const Moment& moment) const;

  /// What the words take of their area.
  const Area& extent() const { return extent_; }

  /// Whether no word has found room.
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
  double y_;  ///< where the next line begins
  double corner_width_ = 0;
  std::vector<Text> texts_;
  std::vector<Value> values_;
  std::vector<std::pair<Area, Color>> samples_;  ///< of curves
  Layer ground_;
};

}  // namespace twrench
