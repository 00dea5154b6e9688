// The legend of the forces, the gauge of their torques, the tilt against time and the principal
// moments.
#include <algorithm>
#include <cmath>

#include "picture/compose/layout_draft.h"

namespace twrench::picture {
namespace {

constexpr double legend_height = 1.25, least_legend = 20;                  // em of a readout
constexpr double least_panel_width = 12, least_height = 6.5;               // em of a caption
constexpr double gauge_height = 5.65, gauge_width = 26, least_gauge = 16;  // em of its text
constexpr int least_over_legend = 6;    // rows of the legend, the height of the bodies above it
constexpr int least_share = 3;          // the focus is at least a third of the pane
constexpr double panel_share = 0.3;     // of the focus
constexpr double moments_share = 0.48;  // of an area that holds both

int shorter_side(const image::Area& area) { return std::min(area.width, area.height); }

bool holds_panel(const image::Area& area, double size) {
  return area.width >= least_panel_width * size && area.height >= least_height * size;
}

}  // namespace

image::Area LayoutDraft::safe_focus() const { return image::common(layout_.panes[0].focus, safe_); }

/// Makes `rest` the focus, after something was cut from it, if the body keeps a third of its pane.
bool LayoutDraft::take_focus(const image::Area& rest) {
  Layout::Pane& pane = layout_.panes[0];
  if (least_share * shorter_side(rest) < shorter_side(pane.area)) return false;
  pane.focus = rest;
  return true;
}

/// Cuts a part off the focus: at its right or, if it is upright, at its bottom.
image::Area LayoutDraft::cut_panels(image::Area& rest) const {
  if (rest.height > rest.width) {
    return cut_bottom(rest, static_cast<int>(panel_share * rest.height), gap_);
  }
  return cut_right(rest, static_cast<int>(panel_share * rest.width), gap_);
}

/// Returns the area. If only the focus is beside it, it is extended to the height of the focus, as
/// far as text leaves room.
image::Area LayoutDraft::beside_focus(image::Area area) const {
  const image::Area focus = safe_focus();
  const bool alone = shown_views().empty() && !(layout_.curve && layout_.components);
  if (!alone || area.x < focus.x + focus.width) return area;
  int top = focus.y, bottom = focus.y + focus.height;
  for (const auto& text : {layout_.title, layout_.readouts}) {
    if (!text || text->x >= area.x + area.width || text->x + text->width <= area.x) continue;
    if (text->y < area.y) top = std::max(top, text->y + text->height + gap_);
    if (text->y > area.y) bottom = std::min(bottom, text->y - gap_);
  }
  bottom = std::max(bottom, area.y + area.height);
  top = std::min(top, area.y);
  return {area.x, top, area.width, bottom - top};
}

/// Divides the area of the curve or the components, or a part of the focus, between tilt and
/// moments.
void LayoutDraft::place_force_panels() {
  const bool tilt = overlay_.shows(scene::Feature::tilt);
  const bool moments = overlay_.shows(scene::Feature::moments);
  if (!tilt && !moments) return;
  image::Area rest = safe_focus();
  std::optional<image::Area>& plot = layout_.curve ? layout_.curve : layout_.components;
  image::Area area = plot ? beside_focus(*plot) : cut_panels(rest);
  const double size = layout_.text.caption;
  if (!holds_panel(area, size) || (!plot && !take_focus(rest))) return;
  plot.reset();
  if (tilt && moments) {
    image::Area left = area;
    const bool beside = area.width > 1.6 * area.height;
    const image::Area first =
        beside ? cut_left(left, static_cast<int>(moments_share * area.width), gap_)
               : cut_top(left, static_cast<int>(moments_share * area.height), gap_);
    if (holds_panel(first, size) && holds_panel(left, size)) {
      layout_.moments = first;
      area = left;
    }
  }
  (tilt ? layout_.tilt : layout_.moments) = area;
}

/// Cuts the legend of the forces off the bottom, if the scene shows forces and it fits.
std::optional<image::Area> LayoutDraft::cut_force_legend(image::Area& rest) const {
  const bool has_forces =
      overlay_.shows(scene::Feature::forces) || overlay_.shows(scene::Feature::tip);
  const double size = layout_.text.readout;
  if (!has_forces || rest.width < least_legend * size) return std::nullopt;
  return cut_bottom(rest, static_cast<int>(std::lround(legend_height * size)), gap_);
}

/// Places the legend of the forces below the body.
void LayoutDraft::place_force_legend() {
  image::Area rest = safe_focus();
  const auto row = cut_force_legend(rest);
  if (row && rest.height > 0 && take_focus(rest)) layout_.forces = row;
}

/// Places the legend of the forces below the bodies of a comparison.
void LayoutDraft::place_common_legend() {
  image::Area rest = image::common(rest_, safe_);
  const auto row = cut_force_legend(rest);
  if (!row || rest.height < least_over_legend * row->height) return;
  layout_.forces = row;
  rest_.height = rest.y + rest.height - rest_.y;
}

/// Places the gauge of the torques below the body, in the middle.
void LayoutDraft::place_torques() {
  const double size = torque_text_size(layout_.text);
  image::Area rest = safe_focus();
  const int width = std::min(rest.width, static_cast<int>(gauge_width * size));
  if (!overlay_.shows(scene::Feature::torques) || width < least_gauge * size) return;
  image::Area row = cut_bottom(rest, static_cast<int>(std::lround(gauge_height * size)), gap_);
  if (rest.height <= 0 || !take_focus(rest)) return;
  cut_left(row, (row.width - width) / 2, 0);
  row.width = width;
  layout_.torques = row;
}

/// Places the panels and the legend of a single body, if the scene shows them and they fit.
void LayoutDraft::place_forces() {
  if (overlay_.view != scene::View::wrench || !single()) return;
  place_force_panels();
  place_force_legend();
  place_torques();
}

}  // namespace twrench::picture
