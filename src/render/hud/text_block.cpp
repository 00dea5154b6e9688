#include "render/hud/text_block.h"

#include <algorithm>
#include <cmath>

namespace twrench::render {
namespace {

constexpr double line_height = 1.2;  // em
constexpr double baseline = 0.95;    // em below the top of a line
constexpr double block_gap = 1.3;    // em of the readout, between two of them

double width_of(const std::string& text, const canvas::Font& font, double size) {
  return size * canvas::typeset(font, text).width;
}

}  // namespace

TextBlock::TextBlock(const TextStyle& style, const image::Area& area)
    : style_(style), area_(area), extent_{area.x, area.y, 0, 0}, y_(area.y) {}

void TextBlock::extend(double right, double bottom) {
  extent_.width = std::max(extent_.width, static_cast<int>(std::ceil(right)) - extent_.x);
  extent_.height = std::max(extent_.height, static_cast<int>(std::ceil(bottom)) - extent_.y);
}

void TextBlock::add_line(const std::string& text, const canvas::Font& font, double size,
                         const scene::Color& ink, const scene::Color* curve) {
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
  const double least = std::min(size, style_.sizes.readout);
  const double width =
      canvas::typeset(font, text).width;  // zero, for combining marks without a letter
  const double fitting = width > 0 ? std::clamp(room / width, least, size) : size;
  canvas::Line line = canvas::typeset_within(font, text, room / fitting);
  extend(x + fitting * line.width, y_ + height);
  texts_.push_back({std::move(line), fitting, {x, y_ + baseline * size}, ink});
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
  const double feather = 2.2 * style_.sizes.caption;
  ground_ = layer_around(extent_, static_cast<int>(std::ceil(feather)), picture);
  canvas::Canvas canvas(ground_.image, ground_.x, ground_.y);
  canvas.soft_panel(extent_, feather, {style_.colors.panel, style_.colors.panel_opacity});
  for (const auto& [line, size, at, ink] : texts_) canvas.text(line, size, at, {ink});
  for (const auto& [area, color] : samples_) {
    canvas.rectangle(area.x, area.y, area.width, area.height, {color});
  }
}

Layer TextBlock::draw(const timeline::FrameState& state) const {
  Layer layer = ground_;
  canvas::Canvas canvas(layer.image, layer.x, layer.y);
  for (const auto& [text, size, at, align] : values_) {
    canvas.text(canvas::typeset(style_.typeface.regular, text(state)), size, at,
                {style_.colors.text}, align);
  }
  return layer;
}

}  // namespace twrench::render
