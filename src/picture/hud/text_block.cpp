#include "picture/hud/text_block.h"

#include <algorithm>
#include <cmath>

#include "base/words.h"

namespace twrench::picture {
namespace {

constexpr double line_height = 1.2;       // em
constexpr double baseline = 0.95;         // em below the top of a line
constexpr double block_gap = 1.3;         // em of the readout, between two of them
constexpr double paragraph_line = 1.35;   // em
constexpr double remark_size = 1.15;      // em of the readout
constexpr double bar_height = 1.1;        // em of the readout
constexpr double text_halo_width = 0.12;  // em
constexpr double text_halo_opacity = 0.3;
constexpr double panel_margin = 0.4;  // em of the caption, around the text

double width_of(const std::string& text, const canvas::Font& font, double size) {
  return size * canvas::typeset(font, text).width;
}

std::string joined(const std::vector<std::string>& words, std::size_t first, std::size_t last) {
  std::string text;
  for (std::size_t i = first; i < last; ++i) text += (i > first ? " " : "") + words[i];
  return text;
}

/// Breaks the text so that the longer line is as short as possible.
std::pair<std::string, std::string> in_two_lines(const std::string& text,
                                                 const canvas::Font& font) {
  const std::vector<std::string> words = words_of(text);
  std::pair<std::string, std::string> best{text, ""};
  double least = width_of(text, font, 1);
  for (std::size_t i = 1; i < words.size(); ++i) {
    std::pair lines{joined(words, 0, i), joined(words, i, words.size())};
    const double width = std::max(width_of(lines.first, font, 1), width_of(lines.second, font, 1));
    if (width >= least) continue;
    least = width;
    best = std::move(lines);
  }
  return best;
}

/// Returns the first whole pixel at or after `x`. A line that was scaled to the width of its area
/// may exceed it by a rounding error, which must not count as another pixel.
int pixel_after(double x) { return static_cast<int>(std::ceil(x - 1e-9)); }

}  // namespace

TextBlock::TextBlock(const TextStyle& style, const image::Area& area)
    : style_(style), area_(area), extent_{area.x, area.y, 0, 0}, y_(area.y) {}

void TextBlock::extend(double right, double bottom) {
  extent_.width = std::max(extent_.width, pixel_after(right) - extent_.x);
  extent_.height = std::max(extent_.height, pixel_after(bottom) - extent_.y);
}

void TextBlock::add_line(const std::string& text, const canvas::Font& font, double size,
                         const Color& ink, const Color* curve) {
  const double height = line_height * size;
  if (!has_room_below(height)) return;
  double x = area_.x;
  if (curve != nullptr) {
    const double length = 0.8 * size;
    const int thickness = std::max(2, static_cast<int>(std::lround(0.1 * size)));
    const auto middle = static_cast<int>(std::lround(y_ + (baseline - 0.36) * size));
    samples_.push_back(
        {{area_.x, middle - thickness / 2, static_cast<int>(length), thickness}, *curve});
    x += length + 0.35 * size;
  }
  const double least = std::min(size, style_.sizes.readout);
  const double width = width_of(text, font, 1);  // zero, for combining marks without a letter
  const double fitting = width > 0 ? std::clamp(room(x) / width, least, size) : size;
  canvas::Line line = canvas::typeset_within(font, text, room(x) / fitting);
  extend(x + fitting * line.width, y_ + height);
  texts_.push_back({std::move(line), fitting, {x, y_ + baseline * size}, ink});
  y_ += height;
}

void TextBlock::add_title(const std::string& text, const canvas::Font& font, double size,
                          const Color& ink) {
  const bool fits = width_of(text, font, size) <= room(area_.x);
  const auto [first, second] = fits || !has_room_below(2 * line_height * size)
                                   ? std::pair(text, std::string())
                                   : in_two_lines(text, font);
  if (second.empty()) return add_line(text, font, size, ink);
  const double width = std::max(width_of(first, font, 1), width_of(second, font, 1));
  const double fitting =
      std::clamp(room(area_.x) / width, std::min(size, style_.sizes.readout), size);
  add_line(first, font, fitting, ink);
  add_line(second, font, fitting, ink);
}

void TextBlock::add_paragraph(const std::string& text, const canvas::Font& font, double size,
                              const Color& ink) {
  const std::vector<std::string> words = words_of(text);
  const double height = paragraph_line * size, width = room(area_.x);
  for (std::size_t i = 0; i < words.size() && has_room_below(height);) {
    std::size_t end = i + 1;
    while (end < words.size() && width_of(joined(words, i, end + 1), font, size) <= width) ++end;
    // The last line that has room ends with an ellipsis where words are left.
    const bool last = y_ + 2 * height > area_.y + area_.height + 1;
    canvas::Line line =
        canvas::typeset_within(font, joined(words, i, last ? words.size() : end), width / size);
    extend(area_.x + size * line.width, y_ + height);
    texts_.push_back(
        {std::move(line), size, {static_cast<double>(area_.x), y_ + baseline * size}, ink});
    y_ += height;
    i = end;
  }
}

void TextBlock::add_remark(const std::string& widest,
                           std::function<Remark(const timeline::FrameState&)> remark) {
  const double height = remark_height * style_.sizes.readout;
  if (!has_room_below(height)) return;
  const double width = width_of(widest, style_.typeface.strong, 1);
  const double size = std::min(remark_size * style_.sizes.readout, room(area_.x) / width);
  if (size < style_.sizes.caption) return;
  const canvas::Canvas::Point at{static_cast<double>(area_.x), y_ + baseline * size};
  remarks_.push_back({std::move(remark), size, at});
  extend(area_.x + size * width, y_ + height);
  y_ += height;
}

void TextBlock::place(const Readout& readout, double x, double y, double caption_width) {
  const auto& [title, size, caption] = style_.sizes;
  const canvas::Font& font = style_.typeface.regular;
  const double below = style_.compact ? 0 : caption_height * caption;
  const double base = y + below + baseline * size;
  const canvas::Canvas::Point at{x, style_.compact ? base : y + baseline * caption};
  texts_.push_back({canvas::typeset(font, readout.caption), caption, at, style_.colors.dim});
  values_.push_back({readout.value, size, {x + caption_width, base}, canvas::Canvas::Align::left});
}

void TextBlock::add_bar(double share, const Color& color) {
  const double size = style_.sizes.readout;
  if (!has_room_below(bar_height * size)) return;
  const image::Area bar{area_.x, static_cast<int>(std::lround(y_ + 0.3 * size)),
                        std::max(1, static_cast<int>(share * area_.width)),
                        std::max(2, static_cast<int>(std::lround(0.4 * size)))};
  samples_.push_back({bar, color});
  extend(bar.x + bar.width, y_ + bar_height * size);
  y_ += bar_height * size;
}

void TextBlock::add_readouts(const std::vector<Readout>& readouts) {
  const auto& [title, size, caption] = style_.sizes;
  const canvas::Font& font = style_.typeface.regular;
  const double height = readouts_height(style_.sizes, style_.compact, 1);
  const bool column = area_.height > area_.width;
  double x = area_.x;
  double y = y_;
  for (const Readout& readout : readouts) {
    const double words = width_of(readout.caption, font, caption);
    const double value = width_of(readout.widest, font, size);
    const double before = style_.compact ? words + 0.5 * size : 0;
    const double width = style_.compact ? before + value : std::max(words, value);
    if (x > area_.x && (column || x + width > area_.x + area_.width)) {
      x = area_.x;
      y += height + readout_row_gap * size;
    }
    if (y + height > area_.y + area_.height + 1 || x + width > area_.x + area_.width) return;
    place(readout, x, y, before);
    extend(x + width, y + height);
    x += width + block_gap * size;
    y_ = y + height;
  }
}

void TextBlock::add_corner(Readout readout) {
  const double size = style_.sizes.readout;
  const double width = width_of(readout.widest, style_.typeface.regular, size);
  const double right = area_.x + area_.width;
  const double base = area_.y + baseline * style_.sizes.title;  // that of the title
  values_.push_back({std::move(readout.value), size, {right, base}, canvas::Canvas::Align::right});
  corner_width_ = width + 2 * size;
  extend(right, area_.y + line_height * style_.sizes.title);
}

void TextBlock::finish(const image::Area& picture) {
  const int margin = static_cast<int>(std::ceil(panel_margin * style_.sizes.caption));
  const double reach = 0.3 * style_.sizes.title;  // of the halo, and of marks beyond their line
  ground_ = layer_around(extent_, std::max(margin, static_cast<int>(std::ceil(reach))), picture);
  canvas::Canvas canvas(ground_.image, ground_.x, ground_.y);
  if (style_.panels) {
    const image::Area panel{extent_.x - margin, extent_.y - margin, extent_.width + 2 * margin,
                            extent_.height + 2 * margin};
    canvas.panel(panel, margin, {style_.colors.panel, style_.colors.panel_opacity});
  }
  for (const auto& [line, size, at, ink] : texts_) draw_text(canvas, line, size, at, {ink});
  for (const auto& [area, color] : samples_) {
    canvas.rectangle(area.x, area.y, area.width, area.height, {color});
  }
}

void TextBlock::draw_text(canvas::Canvas& canvas, const canvas::Line& line, double size,
                          const canvas::Canvas::Point& at, const canvas::Canvas::Ink& ink,
                          canvas::Canvas::Align align) const {
  canvas.text_halo(line, size, at, text_halo_width * size,
                   {style_.colors.panel, text_halo_opacity * ink.opacity}, align);
  canvas.text(line, size, at, ink, align);
}

Layer TextBlock::draw(const timeline::FrameState& state) const {
  Layer layer = ground_;
  canvas::Canvas canvas(layer.image, layer.x, layer.y);
  for (const auto& [text, size, at, align] : values_) {
    draw_text(canvas, canvas::typeset(style_.typeface.regular, text(state)), size, at,
              {style_.colors.text}, align);
  }
  for (const auto& [remark, size, at] : remarks_) {
    const auto [text, opacity] = remark(state);
    if (text.empty()) continue;
    draw_text(canvas, canvas::typeset(style_.typeface.strong, text), size, at,
              {style_.colors.text, opacity});
  }
  return layer;
}

}  // namespace twrench::picture
