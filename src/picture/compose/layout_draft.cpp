#include "picture/compose/layout_draft.h"

#include <algorithm>
#include <cmath>

namespace twrench::picture {
namespace {

using Pane = Layout::Pane;

constexpr double safe_margin = 0.05;     // of a side: what television calls the title-safe area
constexpr double least_focus = 1.0 / 3;  // of the shorter side of its pane
constexpr int least_inset = 72;          // px
constexpr int least_curve = 40;          // px high, and twice as wide
constexpr double least_rows = 9;         // em of the captions, of three rows of curves
constexpr int least_components = 150;    // px wide: three curves of 40 px beside one another
constexpr double least_heading = 12;     // em of the caption
constexpr double least_named = 5;        // em, of a view that has room for labels
// Length / width of a picture. In a longer picture, all items are in one line.
constexpr int longest = 3;

int pixels(double length) { return static_cast<int>(std::lround(length)); }
int shorter(const image::Area& area) { return std::min(area.width, area.height); }

}  // namespace

LayoutDraft::LayoutDraft(const scene::Scene& scene, const Parts& parts,
                         TextPlacement text_placement)
    : scene_(scene),
      overlay_(scene.overlay),
      parts_(parts),
      text_placement_(text_placement),
      picture_{0, 0, scene.film.width, scene.film.height},
      gap_(std::max(4, shorter(picture_) / 40)),
      rest_(picture_),
      solutions_(static_cast<int>(scene.overlay.motion_count())) {
  const double side = shorter(picture_);
  layout_.text = {std::max(12.0, 0.040 * side), std::max(10.0, 0.026 * side),
                  std::max(9.0, 0.0185 * side)};
  layout_.compact = side < 300;
  if (layout_.compact) text_placement_ = TextPlacement::with_body;
  const int x = static_cast<int>(std::ceil(safe_margin * picture_.width));
  const int y = static_cast<int>(std::ceil(safe_margin * picture_.height));
  safe_ = {x, y, picture_.width - 2 * x, picture_.height - 2 * y};
  if (scene.caption) place_caption();
  if (std::ranges::find(parts_, true) != parts_.end()) rest_ = safe_;
}

/// A narrower picture has more lines, which are shorter. In one for a telephone they stay above the
/// buttons that applications lay over its lower end.
void LayoutDraft::place_caption() {
  constexpr double em = 0.0565;  // of the shorter side
  constexpr double least = 9;    // px
  const double size = em * shorter(picture_);
  if (size < least) return;
  const int lines = 4 * picture_.width >= 5 * picture_.height   ? 2
                    : 5 * picture_.width >= 4 * picture_.height ? 3
                                                                : 4;
  const int height = pixels(lines * Layout::Caption::line_height * size);
  if (2 * picture_.height >= 3 * picture_.width) {
    constexpr double buttons = 0.2;  // of the height
    const int below = picture_.height - safe_.y - safe_.height;
    cut_bottom(safe_, pixels(buttons * picture_.height) - below, 0);
  }
  layout_.caption = {cut_bottom(safe_, height, gap_), size, lines};
  rest_.height = safe_.y + safe_.height - rest_.y;
}

bool LayoutDraft::is_long() const {
  return std::max(picture_.width, picture_.height) > longest * shorter(picture_);
}

/// Places the method, its readouts and the remark in the pane's corner: beside the body if it is
/// then larger, otherwise above it.
void LayoutDraft::place_legend(image::Area& pane) {
  if (!parts_[readouts_part]) return;
  const auto& [title, readout, caption] = layout_.text;
  const double remark = explains() ? remark_height * readout : 0;
  const int above =
      pixels(1.25 * title + readouts_height(layout_.text, layout_.compact, 1) + remark);
  const int beside = pixels(std::max(9.0 * readout, 0.28 * pane.width));
  const bool aside = std::min(pane.width - beside, pane.height) > pane.height - above;
  layout_.legends.push_back(aside ? cut_left(pane, beside, gap_) : cut_top(pane, above, gap_));
}

/// Divides the area into two lines of panes if there are at least four views. A long picture has
/// one line, in which each view has more room.
std::vector<Share> LayoutDraft::equal_shares(int count, const image::Area& rest) const {
  const int lines = count >= 4 && !is_long() ? 2 : 1;
  const int along = (count + lines - 1) / lines;
  const bool vertical = picture_.height > picture_.width;
  return shares(picture_, rest, vertical ? lines : along, vertical ? along : lines);
}

void LayoutDraft::place_panes() {
  const std::vector<Share> all = equal_shares(solutions_, rest_);
  for (const auto& [area, column, row] : all) {
    image::Area focus = image::common(area, rest_);
    if (solutions_ > 1 && rest_ != picture_) {
      const int air = gap_ / 2;  // between panes
      if (column > 0) cut_left(focus, 0, air);
      if (column < all.back().column) cut_right(focus, 0, air);
      if (row > 0) cut_top(focus, 0, air);
      if (row < all.back().row) cut_bottom(focus, 0, air);
      place_legend(focus);
    }
    layout_.panes.push_back({area, focus});
  }
}

int LayoutDraft::heading_height() const {
  return explains() ? pixels(1.5 * layout_.text.caption) : 0;
}

/// Cuts the line that names the contents of an inset, if there is room for one.
std::optional<image::Area> LayoutDraft::cut_heading(image::Area& cell) const {
  const int height = heading_height();
  if (height == 0 || cell.width < least_heading * layout_.text.caption) return {};
  return cut_top(cell, height, 0);
}

/// Places the body, all insets and, if a pane is left over, the components.
void LayoutDraft::place_quarters() {
  constexpr std::size_t views = 1 + scene::insets.size();
  constexpr int panes = std::max<int>(4, views);
  image::Area rest_on_the_left = rest_;
  if (has_text_on_the_left()) {
    rest_on_the_left.width = (rest_.width - gap_) / 2;
    place_text(rest_on_the_left);
    rest_on_the_left.width = rest_.width;
  }
  std::vector<Share> all = equal_shares(panes, rest_);
  const std::vector<Share> left = equal_shares(panes, rest_on_the_left);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].column == 0) all[i] = left[i];
  }
  const auto quarter = [&](std::size_t i) {
    image::Area area = image::common(all[i].area, all[i].column == 0 ? rest_on_the_left : rest_);
    if (all[i].column > 0) cut_left(area, 0, gap_);
    if (all[i].row > 0) cut_top(area, 0, gap_);
    return area;
  };
  layout_.panes.push_back({all[0].area, image::common(all[0].area, rest_on_the_left)});
  for (std::size_t i = 1; i < views; ++i) {
    Pane& view = layout_.insets[i - 1].emplace(Pane{all[i].area, quarter(i)});
    view.heading = cut_heading(view.focus);
  }
  if (all.size() == views) return;
  const image::Area last = image::common(quarter(views), safe_);
  if (holds_components(last)) layout_.components = last;
}

void LayoutDraft::place_views() {
  if (overlay_.view == scene::View::quad) return place_quarters();
  if (overlay_.view == scene::View::wrench) return place_panes();
  layout_.insets[scene::inset_index(overlay_.view)] = Pane{picture_, rest_};
}

bool LayoutDraft::is_safe(const image::Area& area) const {
  return shorter(area) > 0 && image::common(area, safe_) == area;
}

/// Returns whether every line of text shows more than an ellipsis.
bool LayoutDraft::has_room_for_text() const {
  const double title = layout_.text.title, readout = layout_.text.readout;
  const double corner = single() ? 0 : 6 * readout;
  const auto room = [&](const image::Area& area, double width) {
    return is_safe(area) && area.width >= width;
  };
  const bool overlap = layout_.title && layout_.readouts &&
                       shorter(image::common(*layout_.title, *layout_.readouts)) > 0;
  return !overlap && (!layout_.title || room(*layout_.title, 6 * title + corner)) &&
         (!layout_.readouts || room(*layout_.readouts, 6 * readout)) &&
         std::ranges::all_of(layout_.legends,
                             [&](const image::Area& legend) { return room(legend, 8 * readout); });
}

bool LayoutDraft::holds_components(const image::Area& area) const {
  const double rows = std::max<double>(least_square, least_rows * layout_.text.caption);
  return is_safe(area) && area.width >= least_components &&
         area.height >= (is_strip(area) ? least_inset : rows);
}

bool LayoutDraft::holds_curve(const image::Area& area) const {
  return is_safe(area) && area.width >= 2 * least_curve && area.height >= least_curve;
}

bool LayoutDraft::has_room() const {
  const auto enough = [&](const Pane& pane) {
    // A pane also lies behind the caption and the buttons of a telephone.
    const image::Area area = layout_.caption ? image::common(pane.area, safe_) : pane.area;
    return shorter(pane.focus) >= std::max(1.0, least_focus * shorter(area));
  };
  const auto room = [&](const std::optional<Pane>& pane) {
    const bool beside_body = overlay_.view == scene::View::wrench;
    return !pane || (enough(*pane) &&
                     (!beside_body || (is_safe(pane->area) && shorter(pane->area) >= least_inset)));
  };
  return std::ranges::all_of(layout_.panes, enough) && std::ranges::all_of(layout_.insets, room) &&
         (!layout_.components || holds_components(*layout_.components)) &&
         (!layout_.curve || holds_curve(*layout_.curve)) && has_room_for_text();
}

std::optional<Layout> LayoutDraft::finish() {
  place_text_and_insets();
  place_views();
  const bool anything = std::ranges::find(parts_, true) != parts_.end();
  if (anything && !has_room()) return std::nullopt;
  place_forces();
  const auto name = [&](Pane& pane) {
    pane.named = shorter(pane.focus) >= least_named * layout_.text.readout;
  };
  std::ranges::for_each(layout_.panes, name);
  for (std::optional<Pane>& inset : layout_.insets) {
    if (inset) name(*inset);
  }
  return layout_;
}

}  // namespace twrench::picture
