// Places the title, the readouts and the insets.
#include <algorithm>
#include <cmath>
#include <iterator>

#include "picture/compose/layout_draft.h"

namespace twrench::picture {
namespace {

constexpr double components_aspect = 1.3;  // width / height, of nine panels in a square
constexpr double strip_aspect = 4.75;      // of nine in a row
constexpr double curve_aspect = 1.9;
constexpr double least_angle_width = 14, least_angle_height = 7;  // em of the captions
constexpr double least_stretch = 0.85;                            // of a plot beside squares
constexpr double most_stretch = 1.5;                              // of a plot
constexpr double most_insets = 0.65;                              // of a long picture
constexpr double column_width = 0.27;                             // of the picture's width
constexpr double block_height = 0.27;                             // of the picture's height
constexpr double most_strip = 0.28;        // of the height of the panes of a comparison
constexpr int least_pair = 80;             // px, the side of each of two squares in a row
constexpr int least_column = 150;          // px
constexpr double text_width = 28;          // em of the readouts: the text in a long picture
constexpr double readouts_width = 12;      // em, of time and flips in a row
constexpr double drift_width = 7;          // em
constexpr double least_description = 12;   // em of the readouts, the width of a description
constexpr double description_line = 1.35;  // em
constexpr double letter_width = 0.52;      // em of the title, on average

int whole(double length) { return static_cast<int>(std::lround(length)); }

/// Returns the number of characters of the UTF-8 text.
std::ptrdiff_t characters(const std::string& text) {
  return std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; });
}

bool is_square(std::size_t part) { return part >= first_view; }

}  // namespace

/// Returns the views that are shown as insets.
std::vector<LayoutDraft::Inset> LayoutDraft::shown_views() const {
  std::vector<Inset> views;
  for (std::size_t part = first_view; part < parts_.size(); ++part) views.push_back({part, 1});
  return shown(std::move(views));
}

/// Returns those of the insets that are shown.
std::vector<LayoutDraft::Inset> LayoutDraft::shown(std::vector<Inset> insets) const {
  std::erase_if(insets, [this](const Inset& inset) { return !parts_[inset.part]; });
  return insets;
}

void LayoutDraft::place_text_and_insets() {
  const bool insets = !shown_views().empty() || parts_[components_part] || parts_[curve_part];
  if (!single()) {
    place_title(rest_);
    place_strips();
    place_common_legend();
  } else if (is_long()) {
    place_in_line();
  } else if (has_text_on_the_left()) {
    return;  // place_quarters() places it
  } else if (!insets && !(shows_no_body() && explains())) {
    place_text(rest_);
  } else if (upright()) {
    place_block();
  } else {
    place_column();
  }
}

/// Two lines if the title would otherwise be set smaller. Its width is estimated.
double LayoutDraft::title_height(int width) const {
  const auto& [title, readout, caption] = layout_.text;
  const std::string& text = scene_.shown_title();
  const double corner = single() ? 0 : 6 * readout;
  const double length = letter_width * title * static_cast<double>(characters(text));
  const int lines = !overlay_.shows(scene::Feature::hud)                         ? 0
                    : length > width - corner && (upright() || !layout_.compact) ? 2
                                                                                 : 1;
  const bool method = single() && overlay_.shows(scene::Feature::method);
  return 1.2 * lines * title + (method ? 1.8 * caption : 0.0);
}

void LayoutDraft::place_title(image::Area& column) {
  if (parts_[title_part]) layout_.title = cut_top(column, whole(title_height(column.width)), gap_);
}

/// Returns the number of rows that the readouts need, as far as these fit; at least one.
int LayoutDraft::rows_of_readouts(const image::Area& column) const {
  const double needed = readouts_width + (overlay_.shows(scene::Feature::drift) ? drift_width : 0);
  const double wanted = std::ceil(needed * layout_.text.readout / column.width);
  int rows = 1;
  while (rows < wanted &&
         readouts_height(layout_.text, layout_.compact, rows + 1) <= column.height) {
    ++rows;
  }
  return rows;
}

void LayoutDraft::place_readouts(image::Area& column) {
  if (!parts_[readouts_part]) return;
  const double rows = readouts_height(layout_.text, layout_.compact, rows_of_readouts(column));
  const double remark = explains() ? remark_height * layout_.text.readout : 0;
  layout_.readouts = cut_bottom(column, whole(rows + remark), gap_);
}

void LayoutDraft::place_text(image::Area& column) {
  place_title(column);
  place_readouts(column);
}

/// Places the title, the insets or the description, and the readouts beside the body. Two views
/// with plots below them share a row.
void LayoutDraft::place_column() {
  const double width = std::min(column_width * picture_.width, 0.5 * picture_.height);
  image::Area column = cut_right(
      rest_, std::max(whole(width), std::min(least_column, picture_.width / 3)), 2 * gap_);
  const bool aside = text_placement_ == TextPlacement::with_insets || shows_no_body();
  place_text(aside ? column : rest_);
  if (shows_no_body()) {
    return place_description(cut_top(
        column, std::min(whole(12 * description_line * layout_.text.readout), column.height), 0));
  }
  std::vector<Inset> views = shown_views();
  const std::vector<Inset> plots =
      shown({{components_part, 1 / components_aspect}, {curve_part, 1 / curve_aspect}});
  const int side = (column.width - gap_) / 2;
  if (views.size() == 2 && !plots.empty() && side >= least_pair) {
    const int height = std::min(side + heading_height(), column.height / 3);
    place_insets(cut_top(column, height, gap_), false, views);
    views.clear();
  }
  views.insert(views.end(), plots.begin(), plots.end());
  place_insets(column, true, views);
}

/// In an upright picture, places the title above the body. Below the body are the squares, with the
/// plots and the readouts beside them.
void LayoutDraft::place_block() {
  place_title(rest_);
  if (shows_no_body()) {
    const double lines = 6.2 * description_line * layout_.text.readout;
    image::Area block = cut_bottom(rest_, whole(lines), 2 * gap_);
    image::Area corner = cut_left(block, whole(block.width / 3.0), 2 * gap_);
    place_readouts(corner);
    return place_description(block);
  }
  if (text_placement_ == TextPlacement::with_body) place_readouts(rest_);
  const std::vector<Inset> squares = shown_views();
  const std::vector<Inset> plots =
      shown({{components_part, 1 / components_aspect}, {curve_part, 1 / curve_aspect}});
  const auto count = static_cast<int>(squares.size());
  const double share = count == 0                                                     ? 0
                       : plots.empty() && text_placement_ == TextPlacement::with_body ? 1
                       : count == 1                                                   ? 0.44
                                                                                      : 0.6;
  const int width = whole(share * rest_.width);
  int height = whole(block_height * picture_.height);
  if (count > 0) height = std::min(height, (width + gap_) / count - gap_ + heading_height());
  image::Area block = cut_bottom(rest_, height, 2 * gap_);
  if (count > 0) {
    const int needed = std::min(width, count * (height - heading_height() + gap_) - gap_);
    place_insets(cut_left(block, needed, 2 * gap_), false, squares);
  }
  if (text_placement_ == TextPlacement::with_insets) place_readouts(block);
  place_insets(block, true, plots);
}

/// In a long picture, places the title and the readouts at the left, and the insets at the right.
/// If it is upright, the title is at the top, the readouts are at the bottom, and the insets are
/// above them.
void LayoutDraft::place_in_line() {
  const int breadth = upright() ? rest_.width : rest_.height;
  const bool strip = !upright() && breadth < least_square;
  const double curve = upright() ? 1 / components_aspect : curve_aspect;
  const double components = strip       ? strip_aspect
                            : upright() ? 1 / components_aspect
                                        : components_aspect;
  std::vector<Inset> insets = shown_views();
  std::ranges::copy(shown({{components_part, components}, {curve_part, curve}}),
                    std::back_inserter(insets));
  if (upright()) {
    place_text(rest_);
  } else if (parts_[title_part] || parts_[readouts_part]) {
    const double width = std::min(text_width * layout_.text.readout, rest_.width / 3.0);
    image::Area column = cut_left(rest_, whole(width), 2 * gap_);
    place_text(column);
  }
  if (insets.empty()) return;
  double line = gap_ * (static_cast<double>(insets.size()) - 1);
  for (const Inset& inset : insets) line += inset.length * breadth;
  line = std::min(line, most_insets * (upright() ? rest_.height : rest_.width));
  place_insets(upright() ? cut_bottom(rest_, whole(line), 2 * gap_)
                         : cut_right(rest_, whole(line), 2 * gap_),
               upright(), insets);
}

/// Places the plots below the panes of a comparison, in the picture's full width.
void LayoutDraft::place_strips() {
  const bool portrait = picture_.height > picture_.width;
  const double most = most_strip * rest_.height;
  const auto strip = [&](double aspect) {
    return cut_bottom(rest_, whole(std::min(rest_.width / aspect, most)), gap_);
  };
  if (parts_[curve_part]) layout_.curve = strip(portrait ? 2.6 : 7.5);
  if (parts_[components_part]) layout_.components = strip(portrait ? 1.6 : 5);
  if (layout_.curve && !overlay_.compare.empty()) place_angle();
}

/// Divides the area of the curve, if both halves are large enough.
void LayoutDraft::place_angle() {
  image::Area rest = *layout_.curve;
  const image::Area half = cut_right(rest, (rest.width - gap_) / 2, gap_);
  const double size = layout_.text.caption;
  if (half.width < least_angle_width * size || half.height < least_angle_height * size) return;
  layout_.curve = rest;
  layout_.angle = half;
}

void LayoutDraft::place_description(const image::Area& area) {
  const double size = layout_.text.readout;
  const bool holds =
      area.width >= least_description * size && area.height >= 3 * description_line * size;
  if (holds) layout_.description = area;
}

/// Places the insets in a line. If the line is too short, first the plots and then the squares
/// become smaller. If it is longer, the plots take more room, and the gaps the rest.
void LayoutDraft::place_insets(image::Area area, bool vertical, const std::vector<Inset>& insets) {
  if (insets.empty()) return;
  const int breadth = vertical ? area.width : area.height;
  const int length = vertical ? area.height : area.width;
  const int between = static_cast<int>(insets.size()) - 1;
  double squares = 0, plots = 0;  // lengths wanted
  for (const Inset& inset : insets) {
    (is_square(inset.part) ? squares : plots) += inset.length * breadth;
  }
  const double room = length - between * gap_;
  const double least_plots = squares > 0 ? least_stretch : 0;
  const double plot_scale =
      plots > 0 ? std::clamp((room - squares) / plots, least_plots, most_stretch) : 0;
  const double square_scale =
      squares > 0 ? std::clamp((room - plot_scale * plots) / squares, 0.0, 1.0) : 0;
  std::vector<int> lengths;
  int rest = length;
  for (const Inset& inset : insets) {
    const double scale = is_square(inset.part) ? square_scale : plot_scale;
    lengths.push_back(static_cast<int>(scale * inset.length * breadth));
    rest -= lengths.back();
  }
  const int gap = between > 0 ? rest / between : 0;
  for (std::size_t i = 0; i < insets.size(); ++i) {
    place_inset(insets[i].part,
                vertical ? cut_top(area, lengths[i], gap) : cut_left(area, lengths[i], gap));
  }
}

void LayoutDraft::place_inset(std::size_t part, image::Area cell) {
  if (part == components_part) {
    layout_.components = cell;
  } else if (part == curve_part) {
    layout_.curve = cell;
  } else {
    const auto heading = cut_heading(cell);
    const image::Area square = centred_square(cell);
    layout_.insets[part - first_view] = Layout::Pane{square, square, true, heading};
  }
}

}  // namespace twrench::picture
