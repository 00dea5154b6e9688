// The legend of the forces, their torques, the tilt against time and the principal moments.
#include <algorithm>
#include <cmath>

#include "picture/compose/layout_draft.h"

namespace twrench::picture {
namespace {

constexpr double legend_height = 1.25, least_legend = 20;     // em of a readout
constexpr double least_panel_width = 12, least_height = 6.5;  // em of a caption
constexpr int least_share = 3;          // the focus is at least a third of the pane
constexpr std::size_t most_groups = 4;  // of parts
constexpr int least_over_torques = 4;   // least height of the area, in torques' rows
constexpr double panel_share = 0.3;     // of the focus
constexpr double moments_share = 0.48;  // of an area that holds both

int shorter_side(const image::Area& area) { return std::min(area.width, area.height); }

bool holds_panel(const image::Area& area, double size) {
  return area.width >= least_panel_width * size && area.height >= least_height * size;
}

}  // namespace

/// Returns whether there are torques of forces to compare, of few enough groups of parts.
bool LayoutDraft::compares_torques() const {
  const std::size_t groups = scene::part_groups(scene_.body).size();
  return overlay_.shows(scene::Feature::forces) && scene_.camera.frame != scene::Frame::space &&
         groups >= 2 && groups <= most_groups;
}

int LayoutDraft::torques_height() const {
  return static_cast<int>(std::lround(readouts_height(layout_.text, layout_.compact, 1)));
}

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

/// Divides the area of the curve or the components, or a part of the focus, among tilt, moments and
/// torques.
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
  const int row = torques_height();
  if (compares_torques() && area.height > least_over_torques * row) {
    layout_.torques = cut_bottom(area, row, gap_);
  }
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

/// Places the legend of the forces and, unless the torques are among the panels, the torques above
/// it.
void LayoutDraft::place_force_legend() {
  const double size = layout_.text.readout;
  image::Area rest = safe_focus();
  if (!overlay_.shows(scene::Feature::forces) || rest.width < least_legend * size) return;
  const image::Area row =
      cut_bottom(rest, static_cast<int>(std::lround(legend_height * size)), gap_);
  if (rest.height <= 0 || !take_focus(rest)) return;
  layout_.forces = row;
  if (!compares_torques() || layout_.torques) return;
  const image::Area torques = cut_bottom(rest, torques_height(), gap_);
  if (rest.height > 0 && take_focus(rest)) layout_.torques = torques;
}

/// Places the panels and the legend of a single body, if the scene shows them and they fit.
void LayoutDraft::place_forces() {
  if (overlay_.view != scene::View::wrench || !single()) return;
  place_force_panels();
  place_force_legend();
}

}  // namespace twrench::picture
