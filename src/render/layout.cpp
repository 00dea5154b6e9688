#include "render/layout.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"
#include "scene/names.h"

namespace twrench {
namespace {

using Pane = Layout::Pane;

constexpr double safe_margin = 0.05;       // of a side: what television calls the title-safe area
constexpr double least_focus = 1.0 / 3;    // of the shorter side of its pane
constexpr int least_inset = 72;            // px
constexpr int least_components = 150;      // px wide: nine curves of 40 px
constexpr double components_aspect = 1.3;  // width / height, of nine panels in a square
constexpr double strip_aspect = 9.5;       // of nine in a row

int rounded(double length) { return static_cast<int>(std::lround(length)); }

// Each takes a piece of that length off one side of `rest`, and a gap off beside it.
Area cut_top(Area& rest, int height, int gap) {
  const Area piece{rest.x, rest.y, rest.width, height};
  rest.y += height + gap;
  rest.height -= height + gap;
  return piece;
}

Area cut_bottom(Area& rest, int height, int gap) {
  const Area piece{rest.x, rest.y + rest.height - height, rest.width, height};
  rest.height -= height + gap;
  return piece;
}

Area cut_left(Area& rest, int width, int gap) {
  const Area piece{rest.x, rest.y, width, rest.height};
  rest.x += width + gap;
  rest.width -= width + gap;
  return piece;
}

Area cut_right(Area& rest, int width, int gap) {
  const Area piece{rest.x + rest.width - width, rest.y, width, rest.height};
  rest.width -= width + gap;
  return piece;
}

Area middle_square(const Area& area) {
  const int side = std::min(area.width, area.height);
  return {area.x + (area.width - side) / 2, area.y + (area.height - side) / 2, side, side};
}

/// What is to be shown, in the order in which it is dropped.
enum Part { poinsot_part, momentum_part, components_part, figures_part, title_part, part_count };
using Parts = std::array<bool, part_count>;

Parts parts_of(const Overlay& overlay) {
  const bool single = overlay.compare.size() < 2;
  const bool insets = single && overlay.view == View::wrench;
  Parts parts{};
  parts[poinsot_part] = insets && overlay.shows(Feature::poinsot);
  parts[momentum_part] = insets && overlay.shows(Feature::sphere);
  parts[components_part] = overlay.view == View::wrench && overlay.shows(Feature::components);
  parts[figures_part] = parts[title_part] = overlay.shows(Feature::hud);
  return parts;
}

/// A layout in the making; `rest` is what is still free.
class Draft {
 public:
  Draft(const Scene& scene, const Parts& parts);

  /// Nothing where something has no room.
  std::optional<Layout> finish();

 private:
  void place_words();
  void place_insets();
  void place_strip();
  void place_views();
  void place_panes();
  void place_legend(Area& pane);
  void place_quarters();
  bool has_room() const;

  const Overlay& overlay_;
  Parts parts_;
  Area picture_;
  Area safe_;
  int gap_;
  Area rest_;
  int takes_;
  Layout layout_;
};

Draft::Draft(const Scene& scene, const Parts& parts)
    : overlay_(scene.overlay),
      parts_(parts),
      picture_{0, 0, scene.film.width, scene.film.height},
      gap_(std::max(4, std::min(picture_.width, picture_.height) / 40)),
      rest_(picture_),
      takes_(std::max(1, static_cast<int>(scene.overlay.compare.size()))) {
  const double side = std::min(picture_.width, picture_.height);
  layout_.text = {std::max(12.0, 0.037 * side), std::max(10.0, 0.024 * side),
                  std::max(9.0, 0.0165 * side)};
  layout_.compact = side < 300;
  const int x = static_cast<int>(std::ceil(safe_margin * picture_.width));
  const int y = static_cast<int>(std::ceil(safe_margin * picture_.height));
  safe_ = {x, y, picture_.width - 2 * x, picture_.height - 2 * y};
  if (std::ranges::find(parts_, true) != parts_.end()) rest_ = safe_;
}

void Draft::place_words() {
  const auto& [title, figure, caption] = layout_.text;
  if (parts_[title_part]) {
    const bool subtitle = takes_ == 1 && !layout_.compact;
    const double height = 1.2 * title + (subtitle ? 1.8 * caption : 0.0);
    layout_.title = cut_top(rest_, rounded(height), gap_);
  }
  if (parts_[figures_part] && takes_ == 1) {
    const double height = 1.25 * figure + (layout_.compact ? 0.0 : 1.4 * caption);
    layout_.figures = cut_bottom(rest_, rounded(height), gap_);
  }
}

/// Beside the body in a column or, in an upright picture, below it in a row.
void Draft::place_insets() {
  const bool upright = 10 * picture_.height > 11 * picture_.width;
  const int squares = (parts_[momentum_part] ? 1 : 0) + (parts_[poinsot_part] ? 1 : 0);
  const auto cut = [&](Area& from, int length, int gap) {
    return upright ? cut_right(from, length, gap) : cut_bottom(from, length, gap);
  };
  if (squares == 0 && !parts_[components_part]) return;
  const int wanted = rounded(0.26 * picture_.width);
  const int width = std::max(wanted, std::min(least_components, picture_.width / 3));
  Area insets = upright ? cut_bottom(rest_, rounded(0.26 * picture_.height), 2 * gap_)
                        : cut_right(rest_, width, 2 * gap_);
  if (!upright) {  // down to the edge of the safe area, beside the figures
    if (layout_.figures) {
      insets.height += layout_.figures->height + gap_;
      layout_.figures->width = rest_.width;
    }
    if (layout_.title) {
      insets.y = layout_.title->y;
      insets.height += layout_.title->height + gap_;
      layout_.title->width = rest_.width;
    }
  }
  if (parts_[components_part]) {
    const int length =
        upright
            ? rounded(std::min(0.58 * insets.width, components_aspect * insets.height))
            : rounded(std::min(insets.width / components_aspect, insets.height / (squares + 0.8)));
    layout_.components = squares == 0 && upright ? insets : cut(insets, length, gap_);
  }
  const int length =
      squares == 0 ? 0
                   : ((upright ? insets.width : insets.height) - (squares - 1) * gap_) / squares;
  for (auto* const inset : {&layout_.momentum, &layout_.poinsot}) {
    const Part part = inset == &layout_.momentum ? momentum_part : poinsot_part;
    if (!parts_[part]) continue;
    const Area square = middle_square(cut(insets, length, gap_));
    *inset = Pane{square, square};
  }
}

/// All components in one row below the panes, which are compared.
void Draft::place_strip() {
  if (!parts_[components_part]) return;
  const bool upright = picture_.height > picture_.width;
  const double height = upright ? rest_.width / 3.0 : rest_.width / strip_aspect;
  layout_.components = cut_bottom(rest_, rounded(std::min(height, 0.3 * rest_.height)), gap_);
}

/// The method and its figures, in the pane's corner: above the body, or beside it where there the
/// body would be smaller.
void Draft::place_legend(Area& pane) {
  if (!parts_[figures_part]) return;
  const auto& [title, figure, caption] = layout_.text;
  const double row = 1.25 * figure + (layout_.compact ? 0.0 : 1.4 * caption);
  const int above = rounded(1.25 * title + row);
  const int beside = rounded(std::max(9.0 * figure, 0.28 * pane.width));
  const bool aside = std::min(pane.width - beside, pane.height) > pane.height - above;
  layout_.legends.push_back(aside ? cut_left(pane, beside, gap_) : cut_top(pane, above, gap_));
}

void Draft::place_panes() {
  const bool grid = takes_ == 4;
  const bool upright = picture_.height > picture_.width;
  const int rows = grid ? 2 : upright ? takes_ : 1;
  const int columns = takes_ / rows;
  const auto bounds = [](int from, int length, int last, int count) {
    std::vector<int> edges;  // inner ones share the focus evenly, outer ones are the picture's
    for (int i = 1; i < count; ++i) edges.push_back(from + length * i / count);
    edges.insert(edges.begin(), 0);
    edges.push_back(last);
    return edges;
  };
  const auto xs = bounds(rest_.x, rest_.width, picture_.width, columns);
  const auto ys = bounds(rest_.y, rest_.height, picture_.height, rows);
  for (int i = 0; i < takes_; ++i) {
    const auto column = static_cast<std::size_t>(i % columns);
    const auto row = static_cast<std::size_t>(i / columns);
    const Area area{xs[column], ys[row], xs[column + 1] - xs[column], ys[row + 1] - ys[row]};
    Area focus = common(area, rest_);
    if (takes_ > 1 && rest_ != picture_) {
      const int air = gap_ / 2;  // between panes
      if (column > 0) cut_left(focus, 0, air);
      if (static_cast<int>(column) < columns - 1) cut_right(focus, 0, air);
      if (row > 0) cut_top(focus, 0, air);
      if (static_cast<int>(row) < rows - 1) cut_bottom(focus, 0, air);
      place_legend(focus);
    }
    layout_.panes.push_back({area, focus});
  }
}

void Draft::place_quarters() {
  const int x = picture_.width / 2;
  const int y = rest_.y + rest_.height / 2;
  const auto quarter = [&](const Area& area) {
    const Area focus = common(area, rest_);
    return Pane{area, {focus.x, focus.y, focus.width, focus.height}};
  };
  layout_.panes.push_back(quarter({0, 0, x, y}));
  layout_.momentum = quarter({x, 0, picture_.width - x, y});
  layout_.poinsot = quarter({0, y, x, picture_.height - y});
  Area last = quarter({x, y, picture_.width - x, picture_.height - y}).focus;
  cut_left(last, 0, gap_);
  cut_top(last, 0, gap_);
  layout_.components = common(last, safe_);
}

void Draft::place_views() {
  if (overlay_.view == View::quad) return place_quarters();
  if (overlay_.view == View::momentum) layout_.momentum = Pane{picture_, rest_};
  if (overlay_.view == View::poinsot) layout_.poinsot = Pane{picture_, rest_};
  if (overlay_.view == View::wrench) place_panes();
}

bool Draft::has_room() const {
  const auto shorter = [](const Area& area) { return std::min(area.width, area.height); };
  const auto enough = [&](const Pane& pane) {
    return shorter(pane.focus) >= std::max(1.0, least_focus * shorter(pane.area));
  };
  const auto room = [&](const std::optional<Pane>& pane, bool inset) {
    return !pane || (enough(*pane) && (!inset || shorter(pane->area) >= least_inset));
  };
  const bool quad = overlay_.view == View::quad;
  return std::ranges::all_of(layout_.panes, enough) &&
         room(layout_.momentum, parts_[momentum_part]) &&
         room(layout_.poinsot, parts_[poinsot_part]) &&
         (quad || !layout_.components ||
          (layout_.components->width >= least_components &&
           layout_.components->height >= least_inset));
}

std::optional<Layout> Draft::finish() {
  place_words();
  if (takes_ == 1) {
    place_insets();
  } else {
    place_strip();
  }
  place_views();
  const bool anything = std::ranges::find(parts_, true) != parts_.end();
  if (anything && !has_room()) return std::nullopt;
  return layout_;
}

}  // namespace

bool is_strip(const Area& components) { return components.width > 4 * components.height; }

Layout layout_of(const Scene& scene) {
  if (scene.overlay.compare.size() > 1 && scene.overlay.view != View::wrench) {
    throw UsageError("compare",
                     "the view '" + name_of(scene.overlay.view) + "' shows one motion only",
                     "methods are compared in the view 'wrench'");
  }
  Parts parts = parts_of(scene.overlay);
  for (bool& part : parts) {
    if (auto layout = Draft(scene, parts).finish()) return *layout;
    part = false;
  }
  return *Draft(scene, parts).finish();
}

}  // namespace twrench
