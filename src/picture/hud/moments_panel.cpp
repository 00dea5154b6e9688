#include "picture/hud/moments_panel.h"

#include <fmt/format.h>
#include <twrench/motion/stability.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "picture/hud/hud_text.h"
#include "picture/hud/panel.h"
#include "picture/views/principal_frame.h"
#include "scene/phrase.h"

namespace twrench::picture {
namespace {

using Point = canvas::Canvas::Point;

constexpr double bar_share = 0.42;                // of the distance between two bars
constexpr double faint_bar = 0.45;                // opacity
constexpr double below_em = 2.6, above_em = 1.6;  // room for the names, and for the values
constexpr double turn_radius_em = 0.95;

std::string moment_text(double moment) {
  if (moment >= 1e6 || moment < 1e-2) return hud_text::setting(moment);
  return moment >= 100 ? fmt::format("{:.0f}", moment) : fmt::format("{:.3g}", moment);
}

/// Draws a circular arrow around `centre`, open at the top.
void draw_turn(canvas::Canvas& canvas, const Point& centre, double radius, double width,
               const Color& color) {
  constexpr double from = -0.3 * std::numbers::pi, to = 1.3 * std::numbers::pi;
  constexpr int pieces = 40;
  std::vector<Point> arc;
  for (int i = 0; i <= pieces; ++i) {
    const double angle = from + (to - from) * i / pieces;
    arc.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
  }
  canvas.polyline(arc, width, {color});
  const Point tip = arc.back();
  const double barb = 0.45 * radius;
  canvas.polyline(std::array{Point{tip.x - barb, tip.y - 0.2 * barb}, tip,
                             Point{tip.x - 0.1 * barb, tip.y + barb}},
                  width, {color});
}

struct Bar {
  double moment;
  std::string name;
  Color color;
  bool turns;
};

std::array<Bar, 3> bars_of(const motion::FreeBody& body, const OverlayColors& colors) {
  const PrincipalFrame frame(body, colors);
  const auto turning = static_cast<std::size_t>(motion::Tilt(body).axis());
  std::array<Bar, 3> bars;
  for (std::size_t i = 0; i < 3; ++i) {
    bars[i] = {body.principal().moments[static_cast<Eigen::Index>(i)], frame.names[i],
               frame.colors[i], i == turning && !body.omega().isZero(0.0)};
  }
  return bars;
}

}  // namespace

MomentsPanel::MomentsPanel(const scene::Scene& scene,
                           const std::vector<timeline::Solution>& solutions, const Layout& layout,
                           const canvas::Typeface& typeface, const OverlayColors& colors) {
  const double size = layout.text.caption;
  const image::Area area = panel_content(*layout.moments, size);
  layer_ = layer_around(*layout.moments, 0, {0, 0, scene.film.width, scene.film.height});
  canvas::Canvas canvas(layer_.image, layer_.x, layer_.y);
  draw_panel(canvas, *layout.moments, size, colors);
  constexpr scene::Phrase heading{"moments of inertia, g cm²", "treghetsmomenter, g cm²"};
  constexpr scene::Phrase shorter{"moments, g cm²", "momenter, g cm²"};
  canvas::Line title = canvas::typeset(typeface.regular, heading.in(scene.language));
  if (title.width * size > area.width) {
    title = canvas::typeset_within(typeface.regular, shorter.in(scene.language), area.width / size);
  }
  canvas.text(title, size, {static_cast<double>(area.x), area.y + 0.95 * size}, {colors.text});
  const std::array<Bar, 3> bars = bars_of(solutions[0].body, colors);
  const double apart = area.width / 3.0, bottom = area.y + area.height - below_em * size;
  const double most = bottom - area.y - (above_em + 1.3) * size;
  const auto middle_of = [&](std::size_t i) {
    return area.x + (static_cast<double>(i) + 0.5) * apart;
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& [moment, name, color, turns] = bars[i];
    const double height = most * moment / bars[2].moment, x = middle_of(i);
    canvas.rectangle(x - bar_share * apart / 2, bottom - height, bar_share * apart, height,
                     {color, turns ? 1 : faint_bar});
    canvas.text(canvas::typeset(typeface.regular, moment_text(moment)), 1.2 * size,
                {x, bottom - height - 0.45 * size}, {colors.text}, canvas::Canvas::Align::centre);
    const double line = bottom + 1.65 * size;
    canvas.text(canvas::typeset(typeface.regular, name), 1.2 * size, {x, line}, {color},
                canvas::Canvas::Align::centre);
    if (turns)
      draw_turn(canvas, {x, line - 0.35 * size}, turn_radius_em * size, 0.12 * size, color);
  }
}

std::vector<Layer> MomentsPanel::draw(const timeline::FrameState& /*state*/) {
  std::vector<Layer> layers;
  layers.push_back(layer_);
  return layers;
}

}  // namespace twrench::picture
