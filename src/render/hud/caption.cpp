#include "render/hud/caption.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include <algorithm>
#include <sstream>

#include "canvas/canvas.h"
#include "canvas/typesetting.h"

namespace twrench::render {
namespace {

constexpr double halo = 0.14;  // em
constexpr double halo_strength = 0.8;

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

/// Fills one line after the other. A word wider than a line stands alone in it.
std::vector<std::string> filled_lines(const canvas::Font& font,
                                      const std::vector<std::string>& words, double width) {
  std::vector<std::string> lines;
  for (const std::string& word : words) {
    const std::string longer = lines.empty() ? word : lines.back() + " " + word;
    if (!lines.empty() && canvas::typeset(font, longer).width <= width) {
      lines.back() = longer;
    } else {
      lines.push_back(word);
    }
  }
  return lines;
}

double widest(const canvas::Font& font, const std::vector<std::string>& lines) {
  double width = 0;
  for (const std::string& line : lines) width = std::max(width, canvas::typeset(font, line).width);
  return width;
}

}  // namespace

std::optional<std::vector<std::string>> broken_into_lines(const canvas::Font& font,
                                                          const std::string& text, double width,
                                                          int most) {
  const std::vector<std::string> words = words_of(text);
  std::vector<std::string> lines = filled_lines(font, words, width);
  const std::size_t count = lines.size();
  if (count > static_cast<std::size_t>(most) || widest(font, lines) > width) return std::nullopt;
  // As narrow as they may be without another line, and so about as long as one another.
  constexpr double step = 0.5;  // em
  while (count > 1) {
    std::vector<std::string> narrower = filled_lines(font, words, widest(font, lines) - step);
    if (narrower.size() > count || widest(font, narrower) >= widest(font, lines)) break;
    lines = std::move(narrower);
  }
  return lines;
}

Caption::Caption(const std::string& text, const Layout::Caption& place,
                 const canvas::Typeface& typeface, const OverlayColors& colors) {
  const auto& [area, size, most] = place;
  canvas::require_characters(typeface.regular, text, "caption");
  const auto lines = broken_into_lines(typeface.regular, text, area.width / size, most);
  if (!lines) {
    throw InvalidArgument("caption",
                          fmt::format("needs more than {} lines in a picture of this shape", most),
                          "shorten it");
  }
  if (lines->empty()) return;
  layer_ = {image::Image(area.width, area.height, 4), area.x, area.y};
  canvas::Canvas canvas(layer_.image, layer_.x, layer_.y);
  const double height = Layout::Caption::line_height * size;
  const auto count = static_cast<double>(lines->size());
  double base = area.y + (area.height - count * height) / 2 + 0.95 * size;
  for (const std::string& line : *lines) {
    const canvas::Line set = canvas::typeset(typeface.regular, line);
    const canvas::Canvas::Point at{area.x + area.width / 2.0, base};
    const auto centre = canvas::Canvas::Align::centre;
    canvas.text_halo(set, size, at, halo * size, {colors.panel, halo_strength}, centre);
    canvas.text(set, size, at, {colors.text}, centre);
    base += height;
  }
}

std::vector<PendingLayer> Caption::draw(const timeline::FrameState& state) {
  std::vector<PendingLayer> layers;
  if (layer_.image.pixels.empty() || state.caption_opacity <= 0) return layers;
  Layer layer = layer_;
  if (state.caption_opacity < 1) scale_opacity(layer, state.caption_opacity);
  layers.push_back(ready(std::move(layer)));
  return layers;
}

}  // namespace twrench::render
