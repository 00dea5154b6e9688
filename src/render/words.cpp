#include "render/words.h"

#include <algorithm>
#include <cmath>

namespace twrench {
namespace {

constexpr double line_height = 1.2;     // em
constexpr double baseline = 0.95;       // em below the top of a line
constexpr double caption_height = 1.4;  // em, of the caption above a readout
constexpr double figure_height = 1.25;  // em
constexpr double between = 1.3;         // em of the readout, between two of them
constexpr double between_rows = 0.35;   // em of the readout

double width_of(const std::string& text, const Font& font, double size) {
  return size * typeset(font, text).width;
}

}  // namespace

double height_of_figures(const Layout::TextSizes& sizes, bool compact, int rows) {
  const double row = figure_height * sizes.figure + (compact ? 0 : caption_height * sizes.caption);
  return rows * row + (rows - 1) * between_rows * sizes.figure;
}

WordBlock::WordBlock(const WordStyle& style, const Area& area)
    : style_(style), area_(area), extent_{area.x, area.y, 0, 0}, y_(area.y) {}

void WordBlock::extend(double right, double bottom) {
  extent_.width = std::max(extent_.width, static_cast<int>(std::ceil(right)) - extent_.x);
  extent_.height = std::max(extent_.height, static_cast<int>(std::ceil(bottom)) - extent_.y);
}

void WordBlock::add_line(const std::string& text, const Font& font, double size, const Color& ink,
                         const Color* curve) {
  const double height = line_height * size;
  if (y_ + height > area_.y + area_.height + 1) return;
  double x = area_.x;
  if (curve != nullptr) {
    const double length = 0.8 * size;
    const int thickness = std::max(2, static_cast<int>(std::lround(0.1 * size)));
    const auto middle = static_cast<int>(std::lround(y_ + (baseline - 0.36) * size));
    samples_.push_back(
        {{area_.x, middle - thickness / 2, static_cast<int>(length), thickness}, *curve});
    x += length + 0.35 * size;
  }
  const double room = area_.x + area_.width - corner_width_ - x;
  const double least = std::min(size, style_.sizes.figure);
  const double width = typeset(font, text).width;  // zero, for combining marks without a letter
  const double fitting = width > 0 ? std::clamp(room / width, least, size) : size;
  Line line = typeset_within(font, text, room / fitting);
  extend(x + fitting * line.width, y_ + height);
  texts_.push_back({std::move(line), fitting, {x, y_ + baseline * size}, ink});
  y_ += height;
}

void WordBlock::place(const Reading& figure, double x, double y, double caption_width) {
  const auto& [title, size, caption] = style_.sizes;
  const Font& font = style_.typeface.regular;
  const double below = style_.compact ? 0 : caption_height * caption;
  const double base = y + below + baseline * size;
  const Canvas::Point at{x, style_.compact ? base : y + baseline * caption};
  texts_.push_back({typeset(font, figure.caption), caption, at, style_.colors.dim});
  values_.push_back({figure.value, size, {x + caption_width, base}, Canvas::Align::left});
}

void WordBlock::add_figures(const std::vector<Reading>& figures) {
  const auto& [title, size, caption] = style_.sizes;
  const Font& font = style_.typeface.regular;
  const double height = height_of_figures(style_.sizes, style_.compact, 1);
  const bool column = area_.height > area_.width;
  double x = area_.x;
  double y = y_;
  for (const Reading& figure : figures) {
    const double words = width_of(figure.caption, font, caption);
    const double value = width_of(figure.widest, font, size);
    const double before = style_.compact ? words + 0.5 * size : 0;
    const double width = style_.compact ? before + value : std::max(words, value);
    if (x > area_.x && (column || x + width > area_.x + area_.width)) {
      x = area_.x;
      y += height + between_rows * size;
    }
    if (y + height > area_.y + area_.height + 1 || x + width > area_.x + area_.width) return;
    place(figure, x, y, before);
    extend(x + width, y + height);
    x += width + between * size;
    y_ = y + height;
  }
}

void WordBlock::add_corner(Reading figure) {
  const double size = style_.sizes.figure;
  const double width = width_of(figure.widest, style_.typeface.regular, size);
  const double right = area_.x + area_.width;
  const double base = area_.y + baseline * style_.sizes.title;  // that of the title
  values_.push_back({std::move(figure.value), size, {right, base}, Canvas::Align::right});
  corner_width_ = width + 2 * size;
  extend(right, area_.y + line_height * style_.sizes.title);
}

void WordBlock::finish(const Area& picture) {
  const double feather = 2.2 * style_.sizes.caption;
  ground_ = layer_around(extent_, static_cast<int>(std::ceil(feather)), picture);
  Canvas canvas(ground_.image, ground_.x, ground_.y);
  canvas.soft_panel(extent_, feather, {style_.colors.panel, style_.colors.panel_opacity});
  for (const auto& [line, size, at, ink] : texts_) canvas.text(line, size, at, {ink});
  for (const auto& [area, color] : samples_) {
    canvas.rectangle(area.x, area.y, area.width, area.height, {color});
  }
}

Layer WordBlock::draw(const Moment& moment) const {
  Layer layer = ground_;
  Canvas canvas(layer.image, layer.x, layer.y);
  for (const auto& [text, size, at, align] : values_) {
    canvas.text(typeset(style_.typeface.regular, text(moment)), size, at, {style_.colors.text},
                align);
  }
  return layer;
}

}  // namespace twrench
