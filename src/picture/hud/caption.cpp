#include "picture/hud/caption.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include <limits>

#include "base/words.h"
#include "canvas/canvas.h"
#include "canvas/typesetting.h"

namespace twrench::picture {
namespace {

constexpr double halo = 0.14;  // em
constexpr double halo_strength = 0.8;

/// Returns the cost of ending a line with that word, on the scale of a line's squared share of the
/// total width.
double reluctance(const std::string& word) {
  constexpr double at_sentence = 0, at_comma = 0.04, elsewhere = 0.1;
  switch (word.back()) {
    case '.':
    case '!':
    case '?':
    case ':':
      return at_sentence;
    case ',':
    case ';':
      return at_comma;
    default:
      return elsewhere;
  }
}

/// Divides words into lines of about the same length that end with a sentence or a comma if
/// possible.
class LineBreaker {
 public:
  LineBreaker(const canvas::Font& font, const std::vector<std::string>& words, double width)
      : words_(words), width_(width) {
    const double space = canvas::typeset(font, "n n").width - canvas::typeset(font, "nn").width;
    for (const std::string& word : words) {
      ends_.push_back(ends_.back() + canvas::typeset(font, word).width + space);
    }
    space_ = space;
  }

  /// Returns nothing if the words do not fit into that many lines.
  std::optional<std::vector<std::string>> broken(int count) const;

 private:
  double width_of(std::size_t first, std::size_t end) const {
    return ends_[end] - ends_[first] - space_;
  }
  double cost(std::size_t first, std::size_t end) const {
    const double share = width_of(first, end) / (ends_.back() - space_);
    return share * share + (end < words_.size() ? reluctance(words_[end - 1]) : 0);
  }

  const std::vector<std::string>& words_;
  double width_, space_ = 0;
  std::vector<double> ends_{0};  ///< In em, each with the space after its word.
};

std::optional<std::vector<std::string>> LineBreaker::broken(int count) const {
  constexpr double never = std::numeric_limits<double>::infinity();
  const std::size_t n = words_.size();
  const auto lines = static_cast<std::size_t>(count);
  // For each number of lines and of words: the least cost, and where the last line begins.
  std::vector<std::vector<double>> least(lines + 1, std::vector<double>(n + 1, never));
  std::vector<std::vector<std::size_t>> begin(lines + 1, std::vector<std::size_t>(n + 1, 0));
  least[0][0] = 0;
  for (std::size_t line = 1; line <= lines; ++line) {
    for (std::size_t end = 1; end <= n; ++end) {
      for (std::size_t first = end; first-- > 0 && width_of(first, end) <= width_;) {
        const double sum = least[line - 1][first] + cost(first, end);
        if (sum >= least[line][end]) continue;
        least[line][end] = sum;
        begin[line][end] = first;
      }
    }
  }
  if (least[lines][n] == never) return std::nullopt;
  std::vector<std::string> result(lines);
  for (std::size_t line = lines, end = n; line > 0; --line) {
    const std::size_t first = begin[line][end];
    for (std::size_t i = first; i < end; ++i) {
      result[line - 1] += (i > first ? " " : "") + words_[i];
    }
    end = first;
  }
  return result;
}

}  // namespace

std::optional<std::vector<std::string>> broken_into_lines(const canvas::Font& font,
                                                          const std::string& text, double width,
                                                          int most) {
  const std::vector<std::string> words = words_of(text);
  if (words.empty()) return std::vector<std::string>{};
  const LineBreaker breaker(font, words, width);
  for (int count = 1; count <= most; ++count) {
    if (auto lines = breaker.broken(count)) return lines;
  }
  return std::nullopt;
}

Caption::Caption(const std::string& text, const Layout::Caption& place,
                 const canvas::Typeface& typeface, const OverlayColors& colors) {
  const auto& [area, size, most] = place;
  canvas::require_characters(typeface.regular, text, "caption");
  const auto lines = broken_into_lines(typeface.regular, text, place.line_width(), most);
  if (!lines) {
    throw InvalidArgument(
        "caption",
        fmt::format("needs more than the {} lines that fit into a picture of this shape", most),
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

std::vector<Layer> Caption::draw(const timeline::FrameState& state) {
  std::vector<Layer> layers;
  if (layer_.image.pixels.empty() || state.caption_opacity <= 0) return layers;
  Layer layer = layer_;
  if (state.caption_opacity < 1) scale_opacity(layer, state.caption_opacity);
  layers.push_back(std::move(layer));
  return layers;
}

}  // namespace twrench::picture
