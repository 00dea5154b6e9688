#include "picture/hud/force_legend.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "picture/hud/panel.h"
#include "picture/look/force_style.h"
#include "scene/phrase.h"

namespace twrench::picture {
namespace {

// In em.
constexpr double sample_length = 1.1, after_sample = 0.4, between_names = 1.4;
constexpr double name_baseline = 0.95;

/// A text of the row, which may have a sample of an arrow before it.
struct Entry {
  canvas::Line name;
  Color color;
  bool has_sample;

  double width() const { return name.width + (has_sample ? sample_length + after_sample : 0); }
};

const scene::Phrase& heading(scene::Frame frame) {
  static constexpr std::array<scene::Phrase, 3> headings{
      {{"in space", "i rommet"},
       {"in the frame of the body", "i legemets system"},
       {"in the rotating frame", "i det roterende systemet"}}};
  return headings.at(static_cast<std::size_t>(frame));
}

double width_of(const std::vector<Entry>& row) {
  double width = (static_cast<double>(row.size()) - 1) * between_names;
  for (const Entry& entry : row) width += entry.width();
  return width;
}

/// Draws the sample, an arrow, from `x` to the right; returns where the name begins.
double draw_sample(canvas::Canvas& canvas, double x, double middle, double size,
                   const Color& color) {
  const double tip = x + sample_length * size, barb = 0.22 * size, width = 0.12 * size;
  const canvas::Canvas::Point shaft[]{{x, middle}, {tip, middle}};
  const canvas::Canvas::Point head[]{
      {tip - 1.3 * barb, middle - barb}, {tip, middle}, {tip - 1.3 * barb, middle + barb}};
  canvas.polyline(shaft, width, {color});
  canvas.polyline(head, width, {color});
  return tip + after_sample * size;
}

}  // namespace

ForceLegend::ForceLegend(const scene::Scene& scene, const Layout& layout, const TextStyle& style) {
  const canvas::Font& font = style.typeface.regular;
  std::vector<Entry> row;
  const auto line = [&](const scene::Phrase& phrase) {
    return canvas::typeset(font, phrase.in(scene.language));
  };
  std::vector<Force> forces;
  if (scene.overlay.shows(scene::Feature::forces)) forces = forces_in(scene.camera.frame);
  if (scene.overlay.shows(scene::Feature::tip)) {
    for (const Force force : forces_on_tip()) {
      if (std::ranges::find(forces, force) == forces.end()) forces.push_back(force);
    }
  }
  for (const Force force : shown_forces(scene.overlay, forces)) {
    row.push_back({line(name_of(force)), color_of(force, style.colors), true});
  }
  row.push_back({line(heading(scene.camera.frame)), style.colors.text, false});
  const image::Area& area = *layout.forces;
  const double size = layout.text.readout;
  if (width_of(row) * size > area.width) row.pop_back();
  const double width = width_of(row) * size;
  if (width > area.width) return;
  const image::Area extent{area.x, area.y, static_cast<int>(std::ceil(width)), area.height};
  const int margin = static_cast<int>(std::ceil(0.3 * size));
  layer_ = layer_around(extent, margin, {0, 0, scene.film.width, scene.film.height});
  canvas::Canvas canvas(layer_.image, layer_.x, layer_.y);
  if (style.panels) draw_panel(canvas, layer_.area(), margin, style.colors);
  const double base = area.y + name_baseline * size;
  double x = area.x;
  for (const auto& [name, color, has_sample] : row) {
    if (has_sample) x = draw_sample(canvas, x, base - 0.34 * size, size, color);
    canvas.text_halo(name, size, {x, base}, 0.12 * size,
                     {style.colors.panel, style.panels ? 0.75 : 0.3});
    canvas.text(name, size, {x, base}, {color});
    x += (name.width + between_names) * size;
  }
}

std::vector<Layer> ForceLegend::draw(const timeline::FrameState& /*state*/) {
  std::vector<Layer> layers;
  if (layer_.image.width > 0) layers.push_back(layer_);
  return layers;
}

}  // namespace twrench::picture
