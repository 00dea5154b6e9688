#pragma once

#include <functional>
#include <string>
#include <vector>

#include "canvas/canvas.h"
#include "picture/compose/layer.h"
#include "picture/compose/layout.h"
#include "picture/look/theme.h"
#include "timeline/timeline.h"

namespace twrench::picture {

/// The style of a text block.
struct TextStyle {
  /// The font.
  const canvas::Typeface& typeface;
  /// Colours of text and panel.
  const OverlayColors& colors;
  /// Text sizes.
  Layout::TextSizes sizes;
  /// Whether captions are beside their readouts instead of above.
  bool compact;
  /// Whether each block has a panel behind it. Arbitrary backgrounds require it.
  bool panels;
};

/// A readout: a changing value with its caption.
struct Readout {
  /// Caption.
  std::string caption;
  /// A text at least as wide as every value.
  std::string widest;
  std::function<std::string(const timeline::FrameState&)> value;
};

/// A remark that comes and goes.
struct Remark {
  /// UTF-8; empty for none.
  std::string text;
  /// 0 to 1.
  double opacity = 1;
};

/// A text block. A thin halo around the letters and, if the style has one, a panel keep it legible
/// on any background. Everything except remarks and the values of the readouts is drawn once.
class TextBlock {
 public:
  /// Uses the part of `area` that the text needs, starting at its top left.
  TextBlock(const TextStyle& style, const image::Area& area);

  /// Adds a line. If it is too long, it is set smaller, down to the readouts' size, and then
  /// truncated. With `curve`, a sample of the curve precedes it.
  void add_line(const std::string& text, const canvas::Font& font, double size, const Color& ink,
                const Color* curve = nullptr);

  /// Adds a line that is broken in two if it would otherwise be set smaller.
  void add_title(const std::string& text, const canvas::Font& font, double size, const Color& ink);

  /// Adds a text in as many lines as it needs. It is truncated if there is not enough room.
  void add_paragraph(const std::string& text, const canvas::Font& font, double size,
                     const Color& ink);

  /// Adds a line for a remark, at most as long as `widest`.
  void add_remark(const std::string& widest,
                  std::function<Remark(const timeline::FrameState&)> remark);

  /// Adds a bar whose length is `share` of the area's width.
  void add_bar(double share, const Color& color);

  /// Adds readouts side by side in rows or, in an upright area, stacked; omits the last ones if
  /// there is not enough room.
  void add_readouts(const std::vector<Readout>& readouts);

  /// Adds a readout without a caption in the top right corner; later lines leave room for it.
  void add_corner(Readout readout);

  /// Completes the block. Halo and panel may extend within `picture`.
  void finish(const image::Area& picture);

  Layer draw(const timeline::FrameState& state) const;

  /// Returns the area that the text covers.
  const image::Area& extent() const { return extent_; }

  /// Returns whether no text fitted.
  bool is_empty() const { return extent_.width <= 0 || extent_.height <= 0; }

 private:
  struct Text {
    canvas::Line line;
    double size;
    canvas::Canvas::Point at;
    Color ink;
  };
  struct Value {
    std::function<std::string(const timeline::FrameState&)> text;
    double size;
    canvas::Canvas::Point at;
    canvas::Canvas::Align align;
  };
  struct PlacedRemark {
    std::function<Remark(const timeline::FrameState&)> remark;
    double size;
    canvas::Canvas::Point at;
  };

  double room(double x) const { return area_.x + area_.width - corner_width_ - x; }
  bool has_room_below(double height) const { return y_ + height <= area_.y + area_.height + 1; }
  void extend(double right, double bottom);
  void draw_text(canvas::Canvas& canvas, const canvas::Line& line, double size,
                 const canvas::Canvas::Point& at, const canvas::Canvas::Ink& ink,
                 canvas::Canvas::Align align = canvas::Canvas::Align::left) const;
  void place(const Readout& readout, double x, double y, double caption_width);

  TextStyle style_;
  image::Area area_;
  image::Area extent_;
  double y_;  ///< Top of the next line.
  double corner_width_ = 0;
  std::vector<Text> texts_;
  std::vector<Value> values_;
  std::vector<PlacedRemark> remarks_;
  std::vector<std::pair<image::Area, Color>> samples_;  ///< Samples of curves.
  Layer ground_;
};

}  // namespace twrench::picture
