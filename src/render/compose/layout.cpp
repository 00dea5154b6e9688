#include "render/compose/layout.h"

#include <twrench/base/error.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "render/compose/cut.h"
#include "scene/names.h"

namespace twrench::render {
namespace {

using Pane = Layout::Pane;

constexpr double safe_margin = 0.05;       // of a side: what television calls the title-safe area
constexpr double least_focus = 1.0 / 3;    // of the shorter side of its pane
constexpr int least_inset = 72;            // px
constexpr int least_components = 150;      // px wide: three curves of 40 px beside one another
constexpr int least_square = 96;           // px high: three curves of 16 px with their names
constexpr double components_aspect = 1.3;  // width / height, of nine panels in a square
constexpr double strip_aspect = 9.5;       // of nine in a row
constexpr double most_insets = 0.65;       // of a long picture
constexpr double least_named = 5;          // em, of a view that has room for labels
constexpr double least_words = 26;         // em of the readouts, the least width of a row
constexpr double words_width = 28;         // em, width of the text beside the body
// Length / width of a picture; in a longer one everything stands in one line.
constexpr int longest = 3;

int rounded(double length) { return static_cast<int>(std::lround(length)); }
int shorter(const image::Area& area) { return std::min(area.width, area.height); }

/// Whether the components are legible in the area.
bool holds_plots(const image::Area& area) {
  return area.width >= least_components &&
         area.height >= (is_strip(area) ? least_inset : least_square);
}

/// The optional parts, in the order in which they are dropped.
enum Part { poinsot_part, momentum_part, components_part, figures_part, title_part, part_count };
using Parts = std::array<bool, part_count>;

Parts parts_of(const scene::Overlay& overlay) {
  const bool single = overlay.compare.size() < 2;
  const bool insets = single && overlay.view == scene::View::wrench;
  Parts parts{};
  parts[poinsot_part] = insets && overlay.shows(scene::Feature::poinsot);
  parts[momentum_part] = insets && overlay.shows(scene::Feature::sphere);
  parts[components_part] =
      overlay.view == scene::View::wrench && overlay.shows(scene::Feature::components);
  parts[figures_part] = parts[title_part] = overlay.shows(scene::Feature::hud);
  return parts;
}

/// A layout in progress; `rest` is the free area.
class Draft {
 public:
  Draft(const scene::Scene& scene, const Parts& parts);

  /// Returns nothing if something does not fit.
  std::optional<Layout> finish();

 private:
  bool is_long() const {
    return std::max(picture_.width, picture_.height) > longest * shorter(picture_);
  }
  bool upright() const { return 10 * picture_.height > 11 * picture_.width; }
  void place_words();
  int rows_of_figures(const image::Area& column) const;
  double readouts_height(int rows) const {
    return twrench::render::readouts_height(layout_.text, layout_.compact, rows);
  }
  void place_insets();
  image::Area cut_insets(int squares);
  void place_strip();
  void place_views();
  std::vector<Share> equal_shares(int count) const;
  void place_panes();
  void place_legend(image::Area& pane);
  void place_quarters();
  bool is_safe(const image::Area& area) const;
  bool has_room_for_words() const;
  bool has_room() const;

  const scene::Overlay& overlay_;
  Parts parts_;
  image::Area picture_;
  image::Area safe_;
  int gap_;
  image::Area rest_;
  int solutions_;
  Layout layout_;
};

Draft::Draft(const scene::Scene& scene, const Parts& parts)
    : overlay_(scene.overlay),
      parts_(parts),
      picture_{0, 0, scene.film.width, scene.film.height},
      gap_(std::max(4, std::min(picture_.width, picture_.height) / 40)),
      rest_(picture_),
      solutions_(std::max(1, static_cast<int>(scene.overlay.compare.size()))) {
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
  const bool subtitle = solutions_ == 1 && !layout_.compact;
  const double title_height = 1.2 * title + (subtitle ? 1.8 * caption : 0.0);
  const bool readouts = parts_[figures_part] && solutions_ == 1;
  const bool aside = is_long() && !upright() && solutions_ == 1 && (parts_[title_part] || readouts);
  const int width = rounded(std::min(words_width * figure, rest_.width / 3.0));
  image::Area column = aside ? cut_left(rest_, width, 2 * gap_) : rest_;
  if (parts_[title_part]) layout_.title = cut_top(column, rounded(title_height), gap_);
  if (readouts) {
    const int height = rounded(readouts_height(rows_of_figures(column)));
    layout_.readouts = cut_bottom(column, height, gap_);
  }
  if (!aside) rest_ = column;
}

/// One row or, in a long picture, as many as the readouts need and as fit.
int Draft::rows_of_figures(const image::Area& column) const {
  if (!is_long()) return 1;
  const double wanted = std::ceil(least_words * layout_.text.readout / column.width);
  int rows = 1;
  while (rows < wanted && readouts_height(rows + 1) <= column.height) ++rows;
  return rows;
}

/// Places the insets beside the body in a column or, in a portrait picture, below it in a row; in a
/// long picture the other way round.
void Draft::place_insets() {
  const int squares = (parts_[momentum_part] ? 1 : 0) + (parts_[poinsot_part] ? 1 : 0);
  if (squares == 0 && !parts_[components_part]) return;
  const bool in_row = upright() != is_long();
  image::Area insets = cut_insets(squares);
  const auto cut = [&](int length) {
    return in_row ? cut_right(insets, length, gap_) : cut_bottom(insets, length, gap_);
  };
  if (parts_[components_part]) {
    const double share = squares == 0 ? 1 : squares + 0.8;
    const int length =
        in_row ? rounded(std::min(0.58 * insets.width, components_aspect * insets.height))
               : rounded(std::min(insets.width / components_aspect, insets.height / share));
    layout_.components = squares == 0 && in_row ? insets : cut(length);
  }
  if (squares == 0) return;
  const int length = ((in_row ? insets.width : insets.height) - (squares - 1) * gap_) / squares;
  for (auto* const inset : {&layout_.momentum, &layout_.poinsot}) {
    const Part part = inset == &layout_.momentum ? momentum_part : poinsot_part;
    if (!parts_[part]) continue;
    const image::Area square = centred_square(cut(length));
    *inset = Pane{square, square};
  }
}

/// Cuts the area of the insets: the components, if shown, and that many squares.
image::Area Draft::cut_insets(int squares) {
  const int breadth = upright() ? rest_.width : rest_.height;
  const bool strip = !upright() && breadth < least_square;
  const double aspect = strip ? strip_aspect / 2 : components_aspect;
  const double components = parts_[components_part] ? (upright() ? 1 / aspect : aspect) : 0;
  const double line = (components + squares) * breadth + 2 * gap_;  // of all of them
  if (upright()) {
    const double height =
        is_long() ? std::min(line, most_insets * rest_.height) : 0.26 * picture_.height;
    return cut_bottom(rest_, rounded(height), 2 * gap_);
  }
  if (is_long())
    return cut_right(rest_, rounded(std::min(line, most_insets * rest_.width)), 2 * gap_);
  const int width =
      std::max(rounded(0.26 * picture_.width), std::min(least_components, picture_.width / 3));
  image::Area column = cut_right(rest_, width, 2 * gap_);
  for (auto* const words : {&layout_.title, &layout_.readouts}) {
    if (*words) (*words)->width = rest_.width;
  }
  column.y = safe_.y;  // beside the text too
  column.height = safe_.height;
  return column;
}

/// Places all components in one row below the panes of a comparison.
void Draft::place_strip() {
  if (!parts_[components_part]) return;
  const double height =
      picture_.height > picture_.width ? rest_.width / 3.0 : rest_.width / strip_aspect;
  layout_.components = cut_bottom(rest_, rounded(std::min(height, 0.3 * rest_.height)), gap_);
}

/// Places the method and its readouts in the pane's corner: above the body, or beside it if the
/// body would otherwise be smaller.
void Draft::place_legend(image::Area& pane) {
  if (!parts_[figures_part]) return;
  const auto& [title, figure, caption] = layout_.text;
  const int above = rounded(1.25 * title + readouts_height(1));
  const int beside = rounded(std::max(9.0 * figure, 0.28 * pane.width));
  const bool aside = std::min(pane.width - beside, pane.height) > pane.height - above;
  layout_.legends.push_back(aside ? cut_left(pane, beside, gap_) : cut_top(pane, above, gap_));
}

/// Divides the area into a square grid or, in a long picture, a line, where each body has more
/// room.
std::vector<Share> Draft::equal_shares(int count) const {
  const bool square = count == 4 && !is_long();
  const int rows = square ? 2 : picture_.height > picture_.width ? count : 1;
  return shares(picture_, rest_, count / rows, rows);
}

void Draft::place_panes() {
  const std::vector<Share> all = equal_shares(solutions_);
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

void Draft::place_quarters() {
  const std::vector<Share> all = equal_shares(4);
  const auto pane = [&](std::size_t i) {
    return Pane{all[i].area, image::common(all[i].area, rest_)};
  };
  layout_.panes.push_back(pane(0));
  layout_.momentum = pane(1);
  layout_.poinsot = pane(2);
  image::Area last = image::common(all[3].area, rest_);
  if (all[3].column > 0) cut_left(last, 0, gap_);
  if (all[3].row > 0) cut_top(last, 0, gap_);
  last = image::common(last, safe_);
  if (holds_plots(last)) layout_.components = last;
}

void Draft::place_views() {
  if (overlay_.view == scene::View::quad) return place_quarters();
  if (overlay_.view == scene::View::momentum) layout_.momentum = Pane{picture_, rest_};
  if (overlay_.view == scene::View::poinsot) layout_.poinsot = Pane{picture_, rest_};
  if (overlay_.view == scene::View::wrench) place_panes();
}

bool Draft::is_safe(const image::Area& area) const {
  return shorter(area) > 0 && image::common(area, safe_) == area;
}

/// Whether every line of text shows more than an ellipsis.
bool Draft::has_room_for_words() const {
  const double title = layout_.text.title, figure = layout_.text.readout;
  const double corner = solutions_ > 1 ? 6 * figure : 0;
  const auto room = [&](const image::Area& area, double width) {
    return is_safe(area) && area.width >= width;
  };
  const bool overlap = layout_.title && layout_.readouts &&
                       shorter(image::common(*layout_.title, *layout_.readouts)) > 0;
  return !overlap && (!layout_.title || room(*layout_.title, 6 * title + corner)) &&
         (!layout_.readouts || room(*layout_.readouts, 6 * figure)) &&
         std::ranges::all_of(layout_.legends,
                             [&](const image::Area& legend) { return room(legend, 8 * figure); });
}

bool Draft::has_room() const {
  const auto enough = [&](const Pane& pane) {
    return shorter(pane.focus) >= std::max(1.0, least_focus * shorter(pane.area));
  };
  const auto room = [&](const std::optional<Pane>& pane, bool inset) {
    return !pane || (enough(*pane) &&
                     (!inset || (is_safe(pane->area) && shorter(pane->area) >= least_inset)));
  };
  return std::ranges::all_of(layout_.panes, enough) &&
         room(layout_.momentum, parts_[momentum_part]) &&
         room(layout_.poinsot, parts_[poinsot_part]) &&
         (!layout_.components ||
          (is_safe(*layout_.components) && holds_plots(*layout_.components))) &&
         has_room_for_words();
}

std::optional<Layout> Draft::finish() {
  place_words();
  if (solutions_ == 1) {
    place_insets();
  } else {
    place_strip();
  }
  place_views();
  const bool anything = std::ranges::find(parts_, true) != parts_.end();
  if (anything && !has_room()) return std::nullopt;
  const auto name = [&](Pane& pane) {
    pane.named = shorter(pane.focus) >= least_named * layout_.text.readout;
  };
  std::ranges::for_each(layout_.panes, name);
  if (layout_.momentum) name(*layout_.momentum);
  if (layout_.poinsot) name(*layout_.poinsot);
  return layout_;
}

}  // namespace

double readouts_height(const Layout::TextSizes& sizes, bool compact, int rows) {
  const double row =
      readout_height * sizes.readout + (compact ? 0 : caption_height * sizes.caption);
  return rows * row + (rows - 1) * readout_row_gap * sizes.readout;
}

bool is_strip(const image::Area& components) { return components.width > 4 * components.height; }

Layout compute_layout(const scene::Scene& scene) {
  if (scene.overlay.compare.size() > 1 && scene.overlay.view != scene::View::wrench) {
    throw InvalidArgument(
        "compare", "the view '" + scene::name_of(scene.overlay.view) + "' shows only one motion",
        "use the view 'wrench' to compare methods");
  }
  Parts parts = parts_of(scene.overlay);
  for (bool& part : parts) {
    if (auto layout = Draft(scene, parts).finish()) return *layout;
    part = false;
  }
  return *Draft(scene, parts).finish();
}

}  // namespace twrench::render
