#pragma once

#include <optional>
#include <vector>

#include "image/area.h"
#include "scene/scene.h"

namespace twrench {

/// The layout of the picture. Text and insets stay 5 % of the picture's sides away from its edges,
/// and overlap neither each other nor the focus of any pane. In a picture more than three times as
/// long as it is wide, everything stands in one line, so that each item has the full breadth.
///
/// Items that do not fit are dropped in this order, until the rest has its minimum size and each
/// body a third of its pane: Poinsot's construction, the momentum sphere, the components, the
/// readouts, the title.
struct Layout {
  /// A three-dimensional view.
  struct Pane {
    Area area;          ///< The entire pane.
    Area focus;         ///< The part in which the body is framed, free of other items.
    bool named = true;  ///< Whether there is room for labels.
  };

  /// Text sizes in px per em.
  struct TextSizes {
    /// The title.
    double title;
    /// Values of readouts.
    double figure;
    /// Captions of readouts.
    double caption;
  };

  /// Panes of the body, one per method. They tile the picture or, in the view `quad`, a quarter of
  /// it; none if the view shows no body.
  std::vector<Pane> panes;
  /// The momentum sphere and Poinsot's construction.
  std::optional<Pane> momentum, poinsot;
  /// The nine components.
  std::optional<Area> components;
  /// The title, with the method below it or, in a comparison, the time on the right.
  std::optional<Area> title;
  /// The readouts of a single motion.
  std::optional<Area> figures;
  /// In a comparison, the method and readouts of each pane.
  std::vector<Area> legends;

  /// Text sizes.
  TextSizes text{};
  /// Whether the picture is too small for captions above the readouts.
  bool compact = false;
};

/// Returns whether the nine components stand in one row there instead of three rows of three.
bool is_strip(const Area& components);

/// Computes the layout. Throws UsageError for a comparison in a view that shows only one motion.
Layout layout_of(const Scene& scene);

}  // namespace twrench
