#pragma once

#include <optional>
#include <vector>

#include "image/area.h"
#include "scene/scene.h"

namespace twrench {

/// Where things go in the picture. Words and insets keep 5 % of the picture's sides from its edges,
/// and never overlap one another nor the focus of any pane. In a picture more than three times as
/// long as it is broad all stands in a line, so that each has the whole breadth.
///
/// What finds no room is dropped, in this order, until the rest has its least size and each body a
/// third of its pane: Poinsot's construction, the momentum sphere, the components, the figures, the
/// title.
struct Layout {
  /// A view in three dimensions.
  struct Pane {
    Area area;          ///< all of it
    Area focus;         ///< the part in which the body is to be, uncovered
    bool named = true;  ///< there is room for the names of what is in it
  };

  /// px per em.
  struct TextSizes {
    double title;
    double figure;
    double caption;
  };

  std::vector<Pane> panes;  ///< of the body, one a take: they tile the picture or, in the view
                            ///< `quad`, a quarter of it; none where the view shows no body
  std::optional<Pane> momentum, poinsot;
  std::optional<Area> components;
  std::optional<Area> title;    ///< with the method below it or, in a comparison, the time at right
  std::optional<Area> figures;  ///< of the one take
  std::vector<Area> legends;    ///< in a comparison, one a pane: the method and its figures

  TextSizes text{};
  bool compact = false;  ///< the picture is too small for captions above the figures
};

/// Whether the nine components stand in one row there, not in three of three.
bool is_strip(const Area& components);

/// Throws UsageError for a comparison in a view that shows one motion only.
Layout layout_of(const Scene& scene);

}  // namespace twrench
