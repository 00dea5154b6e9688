#pragma once

#include <array>
#include <optional>
#include <vector>

#include "picture/compose/cut.h"
#include "picture/compose/layout.h"

namespace twrench::picture {

/// The optional parts of a layout in the order of their importance: the last is dropped first. The
/// views of scene::insets come last.
enum Part : std::size_t { title_part, readouts_part, curve_part, components_part, first_view };
using Parts = std::array<bool, first_view + scene::insets.size()>;

/// The least height in px of three rows of curves with their names. If there is less, the
/// components are in one row.
inline constexpr int least_square = 96;

/// The placement of title and readouts in a picture that is not long: with the insets, which makes
/// the body larger, or above and below the body, which leaves more room for the insets.
enum class TextPlacement { with_insets, with_body };

/// A layout in progress. Pieces are cut from `rest_`, the free area, and the views get the
/// remainder.
class LayoutDraft {
 public:
  LayoutDraft(const scene::Scene& scene, const Parts& parts, TextPlacement text_placement);

  /// Returns nothing if something does not fit.
  std::optional<Layout> finish();

 private:
  /// An inset and its length along a line of insets, in units of the line's breadth.
  struct Inset {
    std::size_t part;
    double length;
  };

  bool is_long() const;
  bool upright() const { return 10 * picture_.height > 9 * picture_.width; }
  bool single() const { return solutions_ == 1; }
  /// Returns whether the text is above and below the left panes of four.
  bool has_text_on_the_left() const {
    return overlay_.view == scene::View::quad && !upright() && !is_long();
  }
  bool shows_no_body() const { return scene::inset_index(overlay_.view) < scene::insets.size(); }
  /// Returns whether text explains the motion and the contents of the picture.
  bool explains() const {
    return !layout_.compact && parts_[readouts_part] && overlay_.shows(scene::Feature::hud);
  }
  std::vector<Inset> shown_views() const;
  std::vector<Inset> shown(std::vector<Inset> insets) const;

  void place_caption();

  // Title, readouts and insets: layout_insets.cpp.
  void place_text_and_insets();
  double title_height(int width) const;
  int rows_of_readouts(const image::Area& column) const;
  void place_title(image::Area& column);
  void place_readouts(image::Area& column);
  void place_text(image::Area& column);
  void place_column();
  void place_block();
  void place_in_line();
  void place_strips();
  void place_angle();
  void place_description(const image::Area& area);
  void place_insets(image::Area area, bool vertical, const std::vector<Inset>& insets);
  void place_inset(std::size_t part, image::Area cell);

  // Views: layout_draft.cpp.
  void place_views();
  std::vector<Share> equal_shares(int count, const image::Area& rest) const;
  void place_panes();
  void place_legend(image::Area& pane);
  void place_quarters();
  int heading_height() const;
  std::optional<image::Area> cut_heading(image::Area& cell) const;

  // Forces, tilt and moments: layout_forces.cpp.
  void place_forces();
  void place_force_panels();
  std::optional<image::Area> cut_force_legend(image::Area& rest) const;
  void place_force_legend();
  void place_common_legend();
  void place_torques();
  image::Area safe_focus() const;
  bool take_focus(const image::Area& rest);
  image::Area cut_panels(image::Area& rest) const;
  image::Area beside_focus(image::Area area) const;

  bool is_safe(const image::Area& area) const;
  bool has_room_for_text() const;
  bool holds_components(const image::Area& area) const;
  bool holds_curve(const image::Area& area) const;
  bool has_room() const;

  const scene::Scene& scene_;
  const scene::Overlay& overlay_;
  Parts parts_;
  TextPlacement text_placement_;
  image::Area picture_;
  image::Area safe_;
  int gap_;
  image::Area rest_;
  int solutions_;
  Layout layout_;
};

}  // namespace twrench::picture
