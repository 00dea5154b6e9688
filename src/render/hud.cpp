#include "render/hud.h"

#include <fmt/format.h>

#include <algorithm>

#include "canvas/error.h"
#include "render/hud_text.h"

namespace twrench {
namespace {

/// The common settings of the readouts of a video.
class Figures {
 public:
  Figures(const Scene& scene, const std::vector<Take>& takes, bool compact)
      : longest_(scene.motion.duration),
        resolution_(scene.film.speed / scene.film.fps),
        compact_(compact) {
    for (const Take& take : takes) flips_ = std::max(flips_, take.flip_times.size());
  }

  Reading time() const {
    return {"time", text(longest_),
            [self = *this](const Moment& m) { return self.text(m.instants[0].sample.t); }};
  }
  Reading energy_drift(std::size_t take) const {
    return {compact_ ? "drift" : "energy drift", "+8.8×10⁻¹⁸", [take](const Moment& m) {
              return hud_text::drift(m.instants[take].diagnostics.energy_drift);
            }};
  }
  static Reading orthogonality(std::size_t take) {
    return {"off SO(3)", "8.8×10⁻¹⁸", [take](const Moment& m) {
              return hud_text::error(m.instants[take].diagnostics.orthogonality_error);
            }};
  }
  Reading flips(std::size_t take) const {
    return {"flips", fmt::format("{}", flips_),
            [take](const Moment& m) { return fmt::format("{}", m.instants[take].flips); }};
  }
  Reading next_flip(std::size_t take) const {
    return {"next flip", text(longest_), [take, self = *this](const Moment& m) {
              const auto& next = m.instants[take].next_flip;
              return next ? self.text(*next) : std::string("none");
            }};
  }

 private:
  std::string text(double t) const { return hud_text::seconds(t, longest_, resolution_); }

  double longest_;
  double resolution_;
  bool compact_;
  std::size_t flips_ = 0;
};

void require_characters(const Font& font, const std::string& title) {
  if (const auto missing = missing_character(font, title)) {
    throw MissingGlyph(
        "title",
        fmt::format("contains the character U+{:04X}, which neither the font nor the "
                    "built-in sans can draw",
                    static_cast<std::uint32_t>(*missing)),
        *missing);
  }
}

}  // namespace

Color take_color(const OverlayColors& colors, std::size_t take) {
  const std::array inks{colors.axis[0], colors.axis[2], colors.axis[1], colors.omega};
  return inks.at(take);
}

Hud::Hud(const Scene& scene, const std::vector<Take>& takes, const Layout& layout,
         const Typeface& typeface, const OverlayColors& colors) {
  const auto& [title_size, figure_size, caption_size] = layout.text;
  const WordStyle style{typeface, colors, layout.text, layout.compact};
  const Figures figures(scene, takes, layout.compact);
  if (layout.title) {
    const std::string& title = scene.title.empty() ? scene.name : scene.title;
    require_characters(typeface.strong, title);
    WordBlock& block = blocks_.emplace_back(style, *layout.title);
    if (takes.size() > 1) block.add_corner(figures.time());
    block.add_line(title, typeface.strong, title_size, colors.text);
    if (takes.size() == 1 && !layout.compact) {
      block.add_line(hud_text::method(takes[0]), typeface.regular, caption_size, colors.dim);
    }
  }
  if (layout.figures) {
    WordBlock& block = blocks_.emplace_back(style, *layout.figures);
    std::vector<Reading> row{figures.time(), figures.energy_drift(0)};
    if (takes[0].flips) {
      row.push_back(figures.flips(0));
      row.push_back(figures.next_flip(0));
    }
    block.add_figures(row);
  }
  for (std::size_t i = 0; i < layout.legends.size(); ++i) {
    WordBlock& block = blocks_.emplace_back(style, layout.legends[i]);
    const Color curve = take_color(colors, i);
    block.add_line(std::string(takes[i].method->name), typeface.strong, 0.85 * title_size,
                   colors.text, layout.components ? &curve : nullptr);
    block.add_figures({figures.energy_drift(i), Figures::orthogonality(i), figures.flips(i)});
  }
  const Area picture{0, 0, scene.film.width, scene.film.height};
  for (WordBlock& block : blocks_) block.finish(picture);
}

std::vector<PendingLayer> Hud::draw(const Moment& moment) {
  std::vector<PendingLayer> layers;
  for (const WordBlock& block : blocks_) {
    if (!block.is_empty()) layers.push_back(ready(block.draw(moment)));
  }
  return layers;
}

std::vector<Area> Hud::extents() const {
  std::vector<Area> extents;
  for (const WordBlock& block : blocks_) extents.push_back(block.extent());
  return extents;
}

}  // namespace twrench
