#include "render/hud/hud.h"

#include <fmt/format.h>

#include <algorithm>

#include "canvas/error.h"
#include "render/hud/hud_text.h"

namespace twrench::render {
namespace {

/// The common settings of the readouts of a video.
class Figures {
 public:
  Figures(const scene::Scene& scene, const std::vector<timeline::Solution>& solutions, bool compact)
      : longest_(scene.motion.duration),
        resolution_(scene.film.speed / scene.film.fps),
        compact_(compact) {
    for (const timeline::Solution& solution : solutions)
      flips_ = std::max(flips_, solution.flip_times.size());
  }

  Readout time() const {
    return {"time", text(longest_), [self = *this](const timeline::FrameState& m) {
              return self.text(m.solutions[0].sample.t);
            }};
  }
  Readout energy_drift(std::size_t solution) const {
    return {compact_ ? "drift" : "energy drift", "+8.8×10⁻¹⁸",
            [solution](const timeline::FrameState& m) {
              return hud_text::drift(m.solutions[solution].diagnostics.energy_drift);
            }};
  }
  static Readout orthogonality(std::size_t solution) {
    return {"off SO(3)", "8.8×10⁻¹⁸", [solution](const timeline::FrameState& m) {
              return hud_text::error(m.solutions[solution].diagnostics.orthogonality_error);
            }};
  }
  Readout flips(std::size_t solution) const {
    return {"flips", fmt::format("{}", flips_), [solution](const timeline::FrameState& m) {
              return fmt::format("{}", m.solutions[solution].flips);
            }};
  }
  Readout next_flip(std::size_t solution) const {
    return {"next flip", text(longest_), [solution, self = *this](const timeline::FrameState& m) {
              const auto& next = m.solutions[solution].next_flip;
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

void require_characters(const canvas::Font& font, const std::string& title) {
  if (const auto missing = canvas::missing_character(font, title)) {
    throw canvas::MissingGlyph(
        "title",
        fmt::format("contains the character U+{:04X}, which neither the font nor the "
                    "built-in sans can draw",
                    static_cast<std::uint32_t>(*missing)),
        *missing);
  }
}

}  // namespace

scene::Color solution_color(const OverlayColors& colors, std::size_t solution) {
  const std::array inks{colors.axis[0], colors.axis[2], colors.axis[1], colors.omega};
  return inks.at(solution);
}

Hud::Hud(const scene::Scene& scene, const std::vector<timeline::Solution>& solutions,
         const Layout& layout, const canvas::Typeface& typeface, const OverlayColors& colors) {
  const auto& [title_size, figure_size, caption_size] = layout.text;
  const TextStyle style{typeface, colors, layout.text, layout.compact};
  const Figures figures(scene, solutions, layout.compact);
  if (layout.title) {
    const std::string& title = scene.title.empty() ? scene.name : scene.title;
    require_characters(typeface.strong, title);
    TextBlock& block = blocks_.emplace_back(style, *layout.title);
    if (solutions.size() > 1) block.add_corner(figures.time());
    block.add_line(title, typeface.strong, title_size, colors.text);
    if (solutions.size() == 1 && !layout.compact) {
      block.add_line(hud_text::method(solutions[0]), typeface.regular, caption_size, colors.dim);
    }
  }
  if (layout.readouts) {
    TextBlock& block = blocks_.emplace_back(style, *layout.readouts);
    std::vector<Readout> row{figures.time(), figures.energy_drift(0)};
    if (solutions[0].flips) {
      row.push_back(figures.flips(0));
      row.push_back(figures.next_flip(0));
    }
    block.add_readouts(row);
  }
  for (std::size_t i = 0; i < layout.legends.size(); ++i) {
    TextBlock& block = blocks_.emplace_back(style, layout.legends[i]);
    const scene::Color curve = solution_color(colors, i);
    block.add_line(std::string(solutions[i].method->name), typeface.strong, 0.85 * title_size,
                   colors.text, layout.components ? &curve : nullptr);
    block.add_readouts({figures.energy_drift(i), Figures::orthogonality(i), figures.flips(i)});
  }
  const image::Area picture{0, 0, scene.film.width, scene.film.height};
  for (TextBlock& block : blocks_) block.finish(picture);
}

std::vector<PendingLayer> Hud::draw(const timeline::FrameState& state) {
  std::vector<PendingLayer> layers;
  for (const TextBlock& block : blocks_) {
    if (!block.is_empty()) layers.push_back(ready(block.draw(state)));
  }
  return layers;
}

std::vector<image::Area> Hud::extents() const {
  std::vector<image::Area> extents;
  for (const TextBlock& block : blocks_) extents.push_back(block.extent());
  return extents;
}

}  // namespace twrench::render
